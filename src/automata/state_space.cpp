#include "cobot_command/automata/state_space.h"

namespace cobot_command::automata {

Result<StateSpace, TooManyStates> StateSpace::explore(const Composition& composition,
                                                      std::size_t max_states) {
  StateSpace space(composition);
  Tuple from = composition.initial();
  Tuple to = from;
  space.states_.insert(from.data());
  for (Number state = 0; state < space.size(); ++state) {
    if (space.size() > max_states) return refuse(TooManyStates{max_states});
    space.states_.unpack(state, from.data());
    space.expand(from, to);
  }
  return space;
}

void StateSpace::expand(const Tuple& from, Tuple& to) {
  bool breaks_spec = false;
  std::uint16_t refused = 0;
  composition_->forEachCandidate(from.data(), [&](EventIndex event) {
    switch (composition_->step(from.data(), event, to.data())) {
      case Composition::Step::Possible:
        edges_.push_back({event, states_.insert(to.data()).number});
        break;
      case Composition::Step::BlockedBySpec:
        if (composition_->isControllable(event)) {
          ++refused;
        } else {
          breaks_spec = true;
        }
        break;
      case Composition::Step::NotInPlants:
        break;
    }
  });
  first_edges_.push_back(edges_.size());
  marked_.push_back(composition_->isMarked(from.data()));
  breaks_spec_.push_back(breaks_spec);
  refused_by_spec_.push_back(refused);
}

}  // namespace cobot_command::automata
