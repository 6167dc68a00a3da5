#pragma once

#include <string_view>

#include "reports/check_report.hpp"

namespace asts {

/// A record from its line, without a line end: what check_json() wrote. Throws InputError for any other line, with the
/// reason.
/// Law (tests/reports/check_reading_test.cpp): check_json() of the result is the line and a line end.
CheckRecord check_record_from_json(std::string_view line);

}  // namespace asts
