// The first half of building a graph: which kernels can take part, and who makes what they read.
#pragma once
#include "harness/frame/graph.h"

namespace assay::frame {

struct Candidate {
  Node node = {};
  bool present = true;
  std::string absent_because = {};
  std::map<std::string, std::string> sources =
      {};  // of a read or updated port with producers: the resource that it reads
};

std::string resource_name(const Node&, const Port&);  // "visibility.depth"
bool reads_earlier(const Port&);                      // reads or updates, from a producer

// Every kernel of the frame with its variant, case and live passes; those that cannot take part are absent, with why.
std::vector<Candidate> candidates_of(const GraphInputs&, std::vector<LeftOut>&);
// Resource -> position of the present candidate that makes it.
std::map<std::string, size_t> makers_of(const std::vector<Candidate>&);

}  // namespace assay::frame
