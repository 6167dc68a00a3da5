#pragma once

#include <map>
#include <string>
#include <vector>

#include "lib/mesh/case.hpp"
#include "lib/mesh/refinement_tree.hpp"

namespace asts {

/// The paper's figures and tables as the program makes them: pictures, data for plots, and the tables of the page.
/// Everything is exact but the rounding of places to hundredths of a pixel and of printed decimals, which are the
/// lower ends of enclosures; the same cases give the same bytes.
struct Paper {
  struct File {
    std::string name;
    std::string content;
  };

  std::vector<File> files;                    ///< SVG pictures and .dat files
  std::map<std::string, std::string> tables;  ///< Markdown, by the name that the page uses
};

/// The meshes of figures that are not determined by their captions alone, from tests/cases.
struct PaperCases {
  Case refinement;         ///< the example for Algorithm 2.9: one mark in the corner a step
  Case proof;              ///< the levels in the proof of Theorem 5.3, made by Algorithm 2.9
  Case planar_suitable;    ///< the first planar example after Definition 5.2
  Case planar_unsuitable;  ///< the second one
};

void add_patch_examples(const PaperCases& cases, Paper& paper);
void add_subdivisions(Paper& paper);
void add_refinement_iterations(const PaperCases& cases, Paper& paper);
void add_example_meshes(Paper& paper);
void add_skeletons(const PaperCases& cases, Paper& paper);
void add_planar_examples(const PaperCases& cases, Paper& paper);
void add_proof_levels(const PaperCases& cases, Paper& paper);
void add_proof_perturbations(Paper& paper);
void add_perfect_bsplines(Paper& paper);
void add_case_table(Paper& paper);
void add_complexity(Paper& paper);

/// All of them. Cost: seconds.
Paper make_paper(const PaperCases& cases);

/// The page: a template in which a line "@TABLE name@" stands for a table. Throws InputError when the template names
/// a table that there is not, or leaves one out.
std::string fill_page(const std::string& page, const Paper& paper);

/// The mesh behind the first steps of a case. REQUIRES: the case has so many.
RefinementTree mesh_after(const Case& sequence, std::size_t steps);

/// Rows of cells as a Markdown table; the first row is the head.
std::string markdown_table(const std::vector<std::vector<std::string>>& rows);

}  // namespace asts
