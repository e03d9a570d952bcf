// A problem with all that follows of it, which has to live as long.
#pragma once

#include <utility>

#include "cobot_command/automata/composition.h"
#include "cobot_command/automata/state_space.h"
#include "cobot_command/automata/synthesis.h"

namespace cobot_command::automata {

struct Synthesized {
  explicit Synthesized(Problem of)
      : problem(std::move(of)),
        composition(problem),
        space(*StateSpace::explore(composition, 5000000)),
        synthesis(space) {}
  Synthesized(const Synthesized&) = delete;
  Synthesized& operator=(const Synthesized&) = delete;

  Problem problem;
  Composition composition;
  StateSpace space;
  Synthesis synthesis;
};

}  // namespace cobot_command::automata
