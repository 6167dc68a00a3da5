#pragma once

#include "fuzz/campaign/worker.hpp"

namespace asts {

/// What runs in a worker's process: reads orders from the file until it ends, and sends messages. Lines of text:
/// "unit JSON" gives "meshes HEX", then, after "fresh BITS", "unit TIMES RECORD"; "task JSON" gives
/// "finding JSON".
void serve(const CampaignPlan& plan, std::int64_t timeout_seconds, int file, Beacon& beacon);

std::string order_line(const UnitOrder& order);
std::string order_line(const FindingTask& task);
std::string fresh_line(const std::vector<bool>& fresh);

/// Throws InputError for a line that is none.
Worker::Message parse_message(const std::string& line);

/// One line from a file, without its end; what came behind it stays in `rest`. Nothing at the end of the file.
std::optional<std::string> read_line(int file, std::string& rest);
/// Throws ResourceError when the other side is gone.
void write_line(int file, std::string line);

}  // namespace asts
