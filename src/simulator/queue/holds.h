// Who holds the arm: it goes on when nobody does any more.
#pragma once

#include <array>
#include <cstddef>

namespace cobot_command::simulator {

enum class Holder { Project, Safeguard, Pvt };

class Holds {
 public:
  void add(Holder holder) { of(holder) = true; }
  void remove(Holder holder) { of(holder) = false; }
  [[nodiscard]] bool by(Holder holder) const { return held_[static_cast<std::size_t>(holder)]; }
  [[nodiscard]] bool any() const { return by(Holder::Project) || by(Holder::Safeguard) || by(Holder::Pvt); }

 private:
  [[nodiscard]] bool& of(Holder holder) { return held_[static_cast<std::size_t>(holder)]; }

  std::array<bool, 3> held_{};
};

}  // namespace cobot_command::simulator
