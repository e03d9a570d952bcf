#include "paths/path_record.h"

namespace cobot_command::blocks {

void PathRecord::sent(const PathChain& chain) {
  const PathChain::Sent& sent = chain.sent().all().back();
  driven_.send({sent.piece, &sent.piece->plan}, sent.first);
}

void PathRecord::came(const std::optional<PathStand>& stand) {
  if (stand) driven_.come(stand->point, stand->time);
}

path::DrivenPath PathRecord::driven() const {
  path::DrivenPath driven = driven_;
  if (joints_) static_cast<void>(driven.stand(*joints_));
  return driven;
}

}  // namespace cobot_command::blocks
