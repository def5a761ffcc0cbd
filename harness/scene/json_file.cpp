#include "harness/scene/json_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace assay::scene {

using Json = nlohmann::json;

namespace {

constexpr int kDeepest = 64;  // of a document; real ones stay under 12

// How deep brackets nest outside strings. Counted before parsing: the library's recursion is bounded by it, and a
// parser callback would cost a walk over the parent at every element's end.
int depth_of(std::string_view text) {
  int depth = 0, deepest = 0;
  bool quoted = false;
  for (size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '\\') {
      ++i;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && (c == '[' || c == '{')) {
      deepest = std::max(deepest, ++depth);
    } else if (!quoted && (c == ']' || c == '}')) {
      --depth;
    }
  }
  return deepest;
}

}  // namespace

void refuse(const std::string& place, const std::string& what) { throw std::runtime_error(place + ": " + what); }

void naming(const std::filesystem::path& file, const std::function<void()>& read) {
  try {
    read();
  } catch (const std::exception& e) {
    std::string what = e.what();
    for (char& c : what)
      if (c == '\n' || c == '\r') c = ' ';
    throw std::runtime_error(fmt::format("{}: {}", file.string(), what));
  }
}

std::string read_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (!in) refuse("file", "cannot be read");
  return bytes;
}

Json parse_json(std::string_view text) {
  if (depth_of(text) > kDeepest) refuse("JSON", fmt::format("nested over {} levels deep", kDeepest));
  try {
    Json doc = Json::parse(text);
    if (!doc.is_object()) refuse("JSON", "the document is not an object");
    return doc;
  } catch (const Json::parse_error& e) {
    refuse(fmt::format("JSON, byte {}", e.byte), "not valid JSON");
  }
}

}  // namespace assay::scene
