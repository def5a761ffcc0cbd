#include "harness/frame/hazards.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

namespace assay::frame {

namespace {

using device::Command;
using device::Use;

struct Access {
  const Command* command;
  const Use* use;
  uint32_t ordered_before = 0;  // scopes whose later commands come after this access
};

bool overlap(const Use& a, const Use& b) { return a.offset < b.offset + b.bytes && b.offset < a.offset + a.bytes; }

// A barrier orders what it names first, and what earlier barriers have already ordered before that: dependencies chain.
void pass_barrier(const Command& barrier, Access& a) {
  const bool named = (a.use->scope & ~barrier.from) == 0, chained = (a.ordered_before & barrier.from) != 0;
  if (named || chained) a.ordered_before |= barrier.to;
}

HazardKind kind_of(const Use& first, const Use& second) {
  if (!first.writes) return HazardKind::write_after_read;
  return second.writes && !second.reads ? HazardKind::write_after_write : HazardKind::read_after_write;
}

bool conflict(const Access& first, const Command& second_command, const Use& second) {
  if (!(first.use->writes || second.writes) || !overlap(*first.use, second)) return false;
  const std::string& label = second_command.label;
  const std::string pass = without_row(label);
  if (pass != label && pass == without_row(first.command->label)) return false;
  return (second.scope & ~first.ordered_before) != 0;
}

std::string names_of(uint32_t scopes) {
  constexpr std::pair<uint32_t, const char*> kNames[] = {
      {device::kCompute, "compute"},       {device::kIndirect, "indirect"}, {device::kGraphics, "graphics"},
      {device::kAttachment, "attachment"}, {device::kTransfer, "transfer"}, {device::kHost, "host"}};
  std::vector<const char*> names;
  for (const auto& [scope, name] : kNames)
    if (scopes & scope) names.push_back(name);
  return fmt::format("{}", fmt::join(names, "+"));
}

}  // namespace

const char* name_of(HazardKind k) {
  switch (k) {
    case HazardKind::read_after_write:
      return "read after write";
    case HazardKind::write_after_read:
      return "write after read";
    case HazardKind::write_after_write:
      return "write after write";
  }
  throw std::logic_error("a hazard without a name");
}

std::string without_row(const std::string& label) { return label.substr(0, label.rfind(" row ")); }

std::string to_text(const Hazard& h) {
  return fmt::format("{} of {}: '{}' (port {}) then '{}' (port {}), and no barrier from {} to {} between",
                     name_of(h.kind), h.resource, h.first, h.first_port, h.second, h.second_port, names_of(h.from),
                     names_of(h.to));
}

std::vector<Hazard> find_hazards(std::span<const Command> commands) {
  std::vector<Hazard> hazards;
  std::map<const device::Resource*, std::vector<Access>> accesses;
  for (const Command& c : commands) {
    if (c.kind == Command::Kind::barrier)
      for (auto& [resource, list] : accesses)
        for (Access& a : list) pass_barrier(c, a);
    for (const Use& use : c.uses)
      for (const Access& before : accesses[use.resource])
        if (conflict(before, c, use))
          hazards.push_back({kind_of(*before.use, use), before.command->label, c.label, before.use->port, use.port,
                             device::name_of(*use.resource), before.use->scope, use.scope});
    for (const Use& use : c.uses) accesses[use.resource].push_back({&c, &use});
  }
  return hazards;
}

void require_no_hazards(std::span<const Command> commands) {
  const auto hazards = find_hazards(commands);
  if (hazards.empty()) return;
  throw std::logic_error(to_text(hazards[0]) +
                         (hazards.size() > 1 ? fmt::format(" ({} hazards in all)", hazards.size()) : ""));
}

}  // namespace assay::frame
