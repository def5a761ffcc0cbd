// Case files: JSON with words in hexadecimal, so that a failure can be read, kept beside the kernel and replayed.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <nlohmann/json.hpp>

#include "harness/check/cases.h"
#include "harness/check/judge.h"

namespace assay::check {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr size_t kWordsALine = 12;
constexpr uint64_t kMostBytes = uint64_t{1} << 30;  // of one input: broken lengths must not exhaust the memory
constexpr uint32_t kMostPixels = 1u << 16;          // a side

// Words, little-endian, a run of equal ones as "00000000*512"; the last one is padded, `bytes` is the true length.
Json words_of(const Bytes& bytes) {
  std::vector<uint32_t> words((bytes.size() + 3) / 4);
  if (!bytes.empty()) std::memcpy(words.data(), bytes.data(), bytes.size());
  Json lines = Json::array();
  std::string line;
  size_t on_line = 0;
  for (size_t i = 0; i < words.size();) {
    size_t end = i + 1;
    while (end < words.size() && words[end] == words[i]) ++end;
    line += fmt::format("{}{:08x}", line.empty() ? "" : " ", words[i]);
    if (end - i > 1) line += fmt::format("*{}", end - i);
    i = end;
    if (++on_line == kWordsALine || i == words.size()) {
      lines.push_back(std::exchange(line, {}));
      on_line = 0;
    }
  }
  return Json{{"bytes", bytes.size()}, {"words", lines}};
}

Json texture_json(const Texture& t) {
  Json json = {{"format", name_of(t.format)},
               {"width", t.width},
               {"height", t.height},
               {"layers", t.layers},
               {"levels", t.levels}};
  json.update(words_of(t.bytes));
  return json;
}

// Where in which file, for errors of one line.
struct Place {
  std::string file, at;
  Place in(const std::string& key) const { return {file, at + "/" + key}; }
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(fmt::format("{}: {}: {}", file, at.empty() ? "/" : at, what));
  }
};

const Json& member(const Json& json, const std::string& key, const Place& place) {
  if (!json.is_object() || !json.contains(key)) place.fail("no \"" + key + "\"");
  return json.at(key);
}

uint64_t whole(const Json& json, uint64_t most, const Place& place) {
  if (!json.is_number_unsigned() || json.get<uint64_t>() > most)
    place.fail(fmt::format("{} is not a whole number up to {}", json.dump(), most));
  return json.get<uint64_t>();
}

uint64_t parse(std::string_view text, int base, const Place& place) {
  uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (error != std::errc{} || end != text.data() + text.size() || text.empty())
    place.fail(fmt::format("'{}' is not a {} number", text, base == 16 ? "hexadecimal" : "decimal"));
  return value;
}

void append_words(std::vector<uint32_t>& words, const std::string& line, size_t most, const Place& place) {
  for (size_t from = line.find_first_not_of(' '); from != std::string::npos; from = line.find_first_not_of(' ', from)) {
    const size_t end = std::min(line.find(' ', from), line.size());
    const std::string_view token = std::string_view(line).substr(from, end - from);
    const size_t star = std::min(token.find('*'), token.size());
    const uint64_t word = parse(token.substr(0, star), 16, place);
    const uint64_t count = star == token.size() ? 1 : parse(token.substr(star + 1), 10, place);
    if (word > 0xffffffffu) place.fail(fmt::format("'{}' is more than 32 bits", token));
    if (count > most - words.size()) place.fail(fmt::format("'{}' is more words than \"bytes\" says", token));
    words.insert(words.end(), count, static_cast<uint32_t>(word));
    from = end;
  }
}

Bytes bytes_of(const Json& json, const Place& place) {
  const uint64_t size = whole(member(json, "bytes", place), kMostBytes, place.in("bytes"));
  const Json& lines = member(json, "words", place);
  if (!lines.is_array()) place.fail("\"words\" is not a list of lines");
  const size_t count = (size + 3) / 4;
  std::vector<uint32_t> words;
  for (size_t i = 0; i < lines.size(); ++i) {
    const Place line = place.in("words").in(std::to_string(i));
    if (!lines[i].is_string()) line.fail("not a line of hexadecimal words");
    append_words(words, lines[i].get<std::string>(), count, line);
  }
  if (words.size() != count) place.fail(fmt::format("{} words for {} bytes", words.size(), size));
  Bytes bytes(size);
  if (size > 0) std::memcpy(bytes.data(), words.data(), size);
  return bytes;
}

Format format_named(const Json& json, const Place& place) {
  for (int f = 0; f <= static_cast<int>(Format::d32_float); ++f)
    if (json.is_string() && json.get<std::string>() == name_of(static_cast<Format>(f))) return static_cast<Format>(f);
  place.fail(json.dump() + " is not a format");
}

Texture texture_of(const Json& json, const Place& place) {
  const auto size = [&](const char* key, uint64_t most) {
    return static_cast<uint32_t>(whole(member(json, key, place), most, place.in(key)));
  };
  Texture t{.format = format_named(member(json, "format", place), place.in("format")),
            .width = size("width", kMostPixels),
            .height = size("height", kMostPixels),
            .layers = size("layers", 2048),
            .levels = size("levels", 17),
            .bytes = bytes_of(json, place)};
  if (t.bytes.size() != bytes_of(t)) place.fail(fmt::format("{} bytes, its size says {}", t.bytes.size(), bytes_of(t)));
  return t;
}

Json read_json(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || fs::is_directory(path)) throw std::runtime_error(path.string() + ": cannot be read");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& e) {
    const auto before = std::string_view(text).substr(0, std::min(e.byte, text.size()));
    throw std::runtime_error(fmt::format("{}: line {}: not JSON", path.string(), 1 + std::ranges::count(before, '\n')));
  }
}

void check_parameters(const Case& c, const Kernel& kernel, const Place& place) {
  if (c.parameters.size() != kernel.params.stride)
    place.fail(fmt::format("{} bytes; {} takes {}", c.parameters.size(), kernel.name, kernel.params.stride));
}

// Sizes follow from extent and parameters, so that a broken file never reaches the device.
void check_input(const Case& c, const Port& port, const Place& place) {
  const auto it = c.inputs.find(port.name);
  if (it == c.inputs.end()) place.fail("no input " + port.name);
  uint64_t count = 0;
  try {
    count = port.kind == PortKind::buffer ? port.count(c) : pixel_count(port.extent ? port.extent(c) : c.extent);
  } catch (const std::exception& e) {
    place.in(port.name).fail(e.what());
  }
  const uint64_t bytes = count * layout_of_port(port).stride;
  if (it->second.size() != bytes)
    place.in(port.name).fail(fmt::format("{} bytes; extent and parameters ask for {}", it->second.size(), bytes));
}

void read_inputs(Case& c, const Json& json, const Kernel& kernel, const Place& place) {
  for (const auto& [name, value] : json.items()) {
    const auto port = std::ranges::find(kernel.ports, name, &Port::name);
    if (port == kernel.ports.end() || port->use == Use::writes) place.fail(kernel.name + " has no input " + name);
    if (port->kind != PortKind::textures) {
      c.inputs[name] = bytes_of(value, place.in(name));
      continue;
    }
    if (!value.is_array()) place.in(name).fail("not a list of textures");
    for (size_t i = 0; i < value.size(); ++i)
      c.textures[name].push_back(texture_of(value[i], place.in(name).in(std::to_string(i))));
  }
  for (const Port& port : kernel.ports)
    if (port.use != Use::writes && port.kind != PortKind::textures) check_input(c, port, place);
}

}  // namespace

void save_case(const fs::path& path, const Kernel& kernel, const Case& c) {
  Json json = {{"kernel", kernel.name},
               {"name", c.name},
               {"seed", fmt::format("{:x}", c.seed)},
               {"width", c.extent.width},
               {"height", c.extent.height},
               {"parameters", words_of(c.parameters)},
               {"inputs", Json::object()}};
  for (const auto& [port, bytes] : c.inputs) json["inputs"][port] = words_of(bytes);
  for (const auto& [port, textures] : c.textures) {
    json["inputs"][port] = Json::array();
    for (const Texture& t : textures) json["inputs"][port].push_back(texture_json(t));
  }
  if (path.has_parent_path()) fs::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file << json.dump(1) << "\n";
  if (!file.flush()) throw std::runtime_error(path.string() + ": cannot be written");
}

std::string kernel_of_case(const fs::path& path) {
  const Json json = read_json(path);
  const Json& kernel = member(json, "kernel", {path.string(), ""});
  if (!kernel.is_string()) Place{path.string(), "/kernel"}.fail("not a kernel's name");
  return kernel.get<std::string>();
}

Case load_case(const fs::path& path, const Kernel& kernel) {
  const Json json = read_json(path);
  const Place top{path.string(), ""};
  const auto text = [&](const char* key) {
    const Json& value = member(json, key, top);
    if (!value.is_string()) top.in(key).fail("not a string");
    return value.get<std::string>();
  };
  if (text("kernel") != kernel.name) top.in("kernel").fail("'" + text("kernel") + "' is not " + kernel.name);
  Case c{.name = text("name"), .seed = parse(text("seed"), 16, top.in("seed"))};
  c.extent.width = static_cast<uint32_t>(whole(member(json, "width", top), kMostPixels, top.in("width")));
  c.extent.height = static_cast<uint32_t>(whole(member(json, "height", top), kMostPixels, top.in("height")));
  c.parameters = bytes_of(member(json, "parameters", top), top.in("parameters"));
  check_parameters(c, kernel, top.in("parameters"));
  const Json& inputs = member(json, "inputs", top);
  if (!inputs.is_object()) top.in("inputs").fail("not an object of inputs");
  read_inputs(c, inputs, kernel, top.in("inputs"));
  return c;
}

}  // namespace assay::check
