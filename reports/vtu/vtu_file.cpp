#include "reports/vtu/vtu_file.hpp"

#include <bit>
#include <cstring>
#include <pugixml.hpp>

#include "reports/base64.hpp"

namespace asts {

namespace {

using XmlNode = pugi::xml_node;

struct ToString : pugi::xml_writer {
  std::string text;
  void write(const void* data, std::size_t size) override { text.append(static_cast<const char*>(data), size); }
};

/// VTK's form of an array within its element: the number of bytes, then the bytes.
std::string with_length(const std::string& bytes) {
  const std::uint64_t length = bytes.size();
  std::string result(sizeof length, '\0');
  std::memcpy(result.data(), &length, sizeof length);
  return result + bytes;
}

/// VTK reads texts as the codes of their characters.
std::string codes(const std::string& bytes) {
  std::string result;
  for (const char byte : bytes) result += std::to_string(static_cast<unsigned char>(byte)) + " ";
  return result;
}

void add_array(XmlNode parent, const VtuArray& array, bool with_tuples = false) {
  const bool texts = array.type == "String";
  XmlNode node = parent.append_child(texts ? "Array" : "DataArray");
  node.append_attribute("type") = array.type.c_str();
  node.append_attribute("Name") = array.name.c_str();
  if (array.components != 1) node.append_attribute("NumberOfComponents") = std::to_string(array.components).c_str();
  if (with_tuples) node.append_attribute("NumberOfTuples") = std::to_string(array.tuples).c_str();
  node.append_attribute("format") = texts ? "ascii" : "binary";
  node.text() = (texts ? codes(array.bytes) : base64(with_length(array.bytes))).c_str();
}

void add_arrays(XmlNode parent, const char* name, const std::vector<VtuArray>& arrays) {
  XmlNode node = parent.append_child(name);
  for (const VtuArray& array : arrays) add_array(node, array);
}

void add_piece(XmlNode grid_node, const VtuGrid& grid) {
  XmlNode piece = grid_node.append_child("Piece");
  piece.append_attribute("NumberOfPoints") = std::to_string(grid.points.size() / 3).c_str();
  piece.append_attribute("NumberOfCells") = std::to_string(grid.types.size()).c_str();
  add_arrays(piece, "PointData", grid.point_data);
  add_arrays(piece, "CellData", grid.cell_data);
  add_array(piece.append_child("Points"), vtu_array("Points", grid.points, 3));
  XmlNode cells = piece.append_child("Cells");
  add_array(cells, vtu_array("connectivity", grid.connectivity));
  add_array(cells, vtu_array("offsets", grid.offsets));
  add_array(cells, vtu_array("types", grid.types));
}

}  // namespace

VtuArray vtu_texts(std::string name, const std::vector<std::string>& texts) {
  std::string bytes;
  for (const std::string& text : texts) bytes += text + '\0';
  return {std::move(name), "String", 1, texts.size(), std::move(bytes)};
}

std::string vtu_text(const VtuGrid& grid) {
  pugi::xml_document document;
  XmlNode file = document.append_child("VTKFile");
  file.append_attribute("type") = "UnstructuredGrid";
  file.append_attribute("version") = "1.0";
  file.append_attribute("byte_order") = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
  file.append_attribute("header_type") = "UInt64";
  XmlNode grid_node = file.append_child("UnstructuredGrid");
  XmlNode fields = grid_node.append_child("FieldData");
  for (const VtuArray& array : grid.field_data) add_array(fields, array, true);
  add_piece(grid_node, grid);
  ToString writer;
  document.save(writer, "", pugi::format_raw, pugi::encoding_utf8);
  return std::move(writer.text);
}

}  // namespace asts
