#pragma once

/// Internal to lib/exact/cosine_field*.cpp: FLINT's and Arb's values with constructors and destructors, and the way
/// between them and ours. Keeps FLINT's headers, which define macros like `ulong`, out of everybody else's sight.

#include <gmp.h>
// GMP first: FLINT declares its mpz and mpq functions only behind it.
#include <arb.h>
#include <arb_fmpz_poly.h>
#include <flint/fmpq.h>
#include <flint/fmpq_poly.h>
#include <flint/fmpz.h>
#include <flint/fmpz_poly.h>

#include "lib/exact/cosine_field.hpp"

namespace asts::flint {

/// Owns one FLINT value of type T, and stands for a pointer to it in FLINT's calls.
template <typename T, void (*Init)(T*), void (*Clear)(T*)>
class Handle {
 public:
  Handle() { Init(&value_); }
  ~Handle() { Clear(&value_); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator T*() { return &value_; }              // NOLINT(google-explicit-constructor): FLINT takes pointers
  operator const T*() const { return &value_; }  // NOLINT(google-explicit-constructor)
  T* operator->() { return &value_; }

 private:
  T value_;
};

using Fmpz = Handle<fmpz, fmpz_init, fmpz_clear>;
using Fmpq = Handle<fmpq, fmpq_init, fmpq_clear>;
using FmpzPoly = Handle<fmpz_poly_struct, fmpz_poly_init, fmpz_poly_clear>;
using FmpqPoly = Handle<fmpq_poly_struct, fmpq_poly_init, fmpq_poly_clear>;
using Ball = Handle<arb_struct, arb_init, arb_clear>;

/// result = sum of coefficients[i] x^i.
inline void set_polynomial(FmpqPoly& result, const std::vector<Rational>& coefficients) {
  Integer denominator = 1;
  for (const Rational& c : coefficients) {
    mpz_ptr raw = denominator.backend().data();
    mpz_lcm(raw, raw, mpq_denref(c.backend().data()));
  }
  FmpzPoly numerators;
  Fmpz coefficient;
  for (std::size_t i = coefficients.size(); i-- > 0;) {  // downwards: FLINT then allocates once
    const Rational scaled = coefficients[i] * denominator;
    fmpz_set_mpz(coefficient, mpq_numref(scaled.backend().data()));
    fmpz_poly_set_coeff_fmpz(numerators, static_cast<slong>(i), coefficient);
  }
  fmpz_set_mpz(coefficient, denominator.backend().data());
  fmpq_poly_set_fmpz_poly(result, numerators);
  fmpq_poly_scalar_div_fmpz(result, result, coefficient);
}

inline std::vector<Rational> coefficients_of(const FmpqPoly& polynomial) {
  std::vector<Rational> result(static_cast<std::size_t>(fmpq_poly_length(polynomial)));
  Fmpq coefficient;
  for (std::size_t i = 0; i < result.size(); ++i) {
    fmpq_poly_get_coeff_fmpq(coefficient, polynomial, static_cast<slong>(i));
    fmpq_get_mpq(result[i].backend().data(), coefficient);
  }
  return result;
}

}  // namespace asts::flint
