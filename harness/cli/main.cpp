// assay: lists, checks, times and shows GPU kernels.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>

#include "harness/cli/command.h"
#include "harness/nearest.h"

namespace {

using namespace assay;

constexpr char kAbout[] =
    "Assay checks compute kernels against exact oracles, times them against what the device can do,\n"
    "and chains them into a frame.\n"
    "\n"
    "  assay devices                 what can be run on\n"
    "  assay list                    what can be run: kernels, variants, hard cases\n"
    "  assay check                   is every variant right?\n"
    "  assay bench                   how fast is each, and how near to the limit?\n"
    "  assay frame --scene small     the whole chain, as a picture\n"
    "  assay mutate                  would the checks notice a fault?\n"
    "  assay diff A.png B.png        how far is a picture off another?\n"
    "\n"
    "Each command teaches itself: assay COMMAND --help.\n"
    "Exit codes: 0 success, 1 a bound is broken, 2 unusable input (one line on stderr says what).";

// `--json` takes a file only where the next word looks like one, so that `check --json visibility` names a kernel.
bool looks_like_file(const std::string& word) {
  return word == "-" || word.ends_with(".json") || word.find('/') != std::string::npos;
}

std::vector<std::string> arguments(int argc, char** argv) {
  std::vector<std::string> words;
  for (int i = 1; i < argc; ++i) {
    std::string word = argv[i];
    if (word == "--json") {
      const bool named = i + 1 < argc && looks_like_file(argv[i + 1]);
      word = "--json=" + std::string(named ? argv[++i] : "-");
    }
    words.insert(words.begin(), std::move(word));  // CLI11 wants them last first
  }
  return words;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

int complain(const std::string& what, int code) {
  fmt::print(stderr, "assay: {}\n", first_line(what));
  return code;
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const auto* command : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(command->get_name());
  return names;
}

int run(int argc, char** argv) {
  CLI::App app(kAbout, "assay");
  app.require_subcommand(1);
  cli::Action action;
  for (const auto add : {cli::add_devices, cli::add_list, cli::add_check, cli::add_bench, cli::add_frame,
                         cli::add_mutate, cli::add_diff})
    add(app, action);
  const std::string first = argc > 1 ? argv[1] : "";
  if (first.empty()) return complain("no command given; try assay --help", cli::kUnusable);
  const auto names = command_names(app);
  if (!first.starts_with('-') && std::ranges::find(names, first) == names.end())
    return complain(fmt::format("no command '{}'{}", first, did_you_mean(first, names)), cli::kUnusable);
  try {
    app.parse(arguments(argc, argv));
  } catch (const CLI::Success& asked) {  // --help
    return app.exit(asked);
  } catch (const CLI::ParseError& e) {
    const auto* command = app.get_subcommands().empty() ? nullptr : app.get_subcommands().front();
    return complain(
        fmt::format("{} (see assay {}--help)", first_line(e.what()), command ? command->get_name() + " " : ""),
        cli::kUnusable);
  }
  return action();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::invalid_argument& e) {  // a logic_error by birth, but here always somebody's input
    return complain(e.what(), cli::kUnusable);
  } catch (const std::logic_error& e) {
    return complain(std::string("a bug in Assay: ") + e.what(), cli::kBug);
  } catch (const std::exception& e) {
    return complain(e.what(), cli::kUnusable);
  }
}
