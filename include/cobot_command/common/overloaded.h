// Combines several lambdas into one visitor for std::visit.
#pragma once

namespace cobot_command {

template <class... Handlers>
struct Overloaded : Handlers... {
  using Handlers::operator()...;
};
template <class... Handlers>
Overloaded(Handlers...) -> Overloaded<Handlers...>;

}  // namespace cobot_command
