// The goals of a chain and what they load, in their order: which piece is to be sent next, and where each
// goal's points are on their way.
//
// Points are counted from the first one of the chain on, whatever goal they are of.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "chain/loaded_path.h"
#include "chain/path_member.h"

#include "cobot_command/blocks/shared/command.h"
#include "cobot_command/blocks/shared/goal_values.h"
#include "cobot_command/common/time.h"

namespace cobot_command::blocks {

class PathChain {
 public:
  using Member = PathMember;
  using Sent = SentPiece;
  /// That it was planned with.
  struct Feedrates {
    double lowest = 1.0;
    double highest = 1.0;
  };
  /// Points in front of `done` are done; those from there to `behind_active` move the robot.
  struct Place {
    std::size_t done = 0;
    std::size_t behind_active = 0;
  };

  /// `planned`: with what is loaded.
  PathChain(GoalId goal, const PathReport& planned) { add(goal, planned); }

  // --- Goals.
  /// Precondition: it was planned behind end().
  void add(GoalId goal, const PathReport& planned);
  /// That a goal which joins it has to be planned behind.
  [[nodiscard]] ChainEnd end() const;
  [[nodiscard]] const std::deque<Member>& members() const { return members_; }
  [[nodiscard]] std::deque<Member>& members() { return members_; }
  /// Nothing: it is none of its goals.
  [[nodiscard]] std::optional<std::size_t> memberOf(GoalId goal) const;
  [[nodiscard]] std::size_t memberAt(std::size_t point) const;
  /// Those whose first point has a place in the buffer pass their gates, in their order, that are open.
  void passGates(const Place& place, const path::TrackingObjects& objects);
  /// That waits at its gate, or will; nullptr: none does.
  [[nodiscard]] const Member* firstAtGate() const;
  /// All goals are to be told, wherever their points are.
  void tellAnew();
  /// Nothing of it is in a piece that was sent.
  [[nodiscard]] bool isUntouched(std::size_t member) const;
  /// With all behind it. Precondition: it is untouched, and not the first one.
  void dropFrom(std::size_t member);
  /// The first one has ended. Precondition: there are others.
  void dropFirst();

  // --- Pieces.
  /// Nothing: all are sent.
  [[nodiscard]] LoadedPiecePtr next() const;
  /// Whose piece that is, or of whom it is the first one; nullptr: all are sent.
  [[nodiscard]] const LoadedPath* nextOf() const;
  /// Of what has been sent, base and TCP are others than they were; no lines: they are not.
  [[nodiscard]] Order restoring() const;
  /// Another one for each piece that could be next.
  [[nodiscard]] CommandKey nextKey() const { return next_key_; }
  /// Whose first point is in it has not passed its gate. Precondition: it is there.
  [[nodiscard]] bool isNextAtGate() const { return !members_[memberAt(sent_points_)].passed_gate; }
  /// What is next could blend with what comes, and is kept for that.
  [[nodiscard]] bool isNextOpen() const;
  /// It has waited enough: it is sent as it is.
  void letOpenEndGo() { open_end_due_ = true; }
  void sendNext();
  /// That are at the controller, in their order.
  [[nodiscard]] const SentPieces& sent() const { return sent_; }
  [[nodiscard]] SentPieces& sent() { return sent_; }

  /// Nothing of it was ever sent.
  [[nodiscard]] bool isUnbegun() const { return most_sent_ == 0; }

  // --- What is to be sent once more, as the robot was stopped on its way.
  /// What is left begins in the motion of that point, at that time of its plan, where the arm rests: it has
  /// no pieces until it is planned. Precondition: nothing is sent, and goals whose points are all in front of
  /// that one are dropped.
  void rewind(std::size_t point, Duration time, const arm::JointVector& joints);
  [[nodiscard]] bool isRewound() const { return rewound_.has_value(); }

  // --- What is not sent, at another feedrate.
  /// Nothing: all is sent.
  [[nodiscard]] std::optional<Feedrates> feedrates() const;
  /// Nothing: all is sent.
  [[nodiscard]] std::optional<PathRest> rest() const;
  /// Takes the place of what rest() told. Precondition: that has not changed since.
  void reload(const std::vector<LoadedPathPtr>& loaded);
  /// See PathPace. `with_sent`: what the controller has, too.
  [[nodiscard]] double highestFeedrate(bool with_sent) const;

  // --- Counts, in the words of the instruction.
  /// Of one goal: what the buffer holds beside the active point, and what waits in front of it.
  [[nodiscard]] PathPlace placeOf(const Member& member, const Place& place) const;

 private:
  /// Of next(): a piece of that member; behind its pieces its open end.
  struct Cursor {
    std::size_t member = 0;
    std::size_t piece = 0;
  };
  /// In their order; of members that begin with those of the one in front, as they are sent.
  [[nodiscard]] std::vector<LoadedPiecePtr> unsent() const;
  /// Points of these pieces from that one on; `first`: of the first piece.
  [[nodiscard]] PathRest restFrom(std::size_t point, const std::vector<LoadedPiecePtr>& pieces,
                                  std::size_t first) const;
  [[nodiscard]] bool isOpenEndOwed() const;
  void advance();
  void tellLostBlends(const Sent& sent);

  std::deque<Member> members_;
  SentPieces sent_;
  Cursor cursor_;
  CommandKey next_key_ = 1;
  bool open_end_due_ = false;
  bool open_end_sent_ = false;  ///< of the member that the cursor is at
  std::size_t sent_points_ = 0;
  std::size_t most_sent_ = 0;  ///< also of what was taken back since
  struct Rewound {
    PathRest rest;
    double highest = 0;  ///< feedrate
  };
  std::optional<Rewound> rewound_;
};

}  // namespace cobot_command::blocks
