#include "apps/lab/attack/attacks.h"

#include "apps/lab/attack/attackers/endless_proposals.h"
#include "apps/lab/attack/attackers/false_tube.h"
#include "apps/lab/attack/attackers/foreign_actions.h"
#include "apps/lab/attack/attackers/gallery.h"
#include "apps/lab/attack/attackers/impostors.h"
#include "apps/lab/attack/attackers/outsiders.h"
#include "apps/lab/attack/attackers/overloads.h"
#include "apps/lab/attack/attackers/returning.h"
#include "apps/lab/attack/attackers/together.h"
#include "apps/lab/attack/attackers/without_effect.h"

#include <array>

namespace carina::lab
{

WayIn wayIn(const Target& target, Role role)
{
    return {target.port, role, target.codes.at(role), target.derive, target.from};
}

bool actsBesideOthers(const AttackKind& kind)
{
    return !kind.isAllOthers && !kind.spoils && !kind.needsRoom
           && kind.strategy == StrategyKind::SessionClock;
}

std::span<const AttackKind> attackKinds()
{
    // One for each coming and going of those who take part: attacker, newcomers, listener.
    constexpr double kComings = 20.0;
    // As many as the host takes from an instructor in a second, and a tenth.
    constexpr double kInstructing = 110.0;
    // Of these, since what is chosen already becomes no fact.
    constexpr double kLeastInstructing = 80.0;
    // Twelve comings and goings, what each may have saved up, and a burst of the pot; then by the
    // second the shares and the pot of trainees of one address, and a tenth (sharedLimitsOf).
    constexpr double kCrowd = 12.0 * (2.0 + 8.0) + 2.0 * 40.0;
    constexpr double kCrowdPerS = 88.0;
    // More than one name has by itself.
    constexpr double kLeastOfMany = 30.0;
    // The names of the turns come in once each, and have saved up as much as those of a crowd.
    constexpr double kTurns = 24.0 * 2.0 + 24.0 * 8.0 + 2.0 * 40.0;
    // Breaths of a manikin in a second, see kShortestBreath.
    constexpr double kBreathing = 1.2;
    // Two tubes, and what they are handed over.
    constexpr double kSharing = 4.0;
    // Whoever floods the host is put out after several seconds, and comes in again: two facts.
    constexpr double kComingAgain = 0.4;
    // The names of one who sends of every kind.
    constexpr double kSteady = 3.0 * 8.0;
    // What one trainee may propose: a burst, and by the second, and a tenth.
    constexpr double kOwn = 44.0;
    constexpr double kOwnPerS = 22.0;
    // Idle ones that the host keeps for a code.
    constexpr double kIdlePaths = 64.0;
    // So many that of one block of memory, 32 bytes at least, for each of them more would be left
    // than a console's memory varies by.
    constexpr double kMany = 250'000.0;
    static constexpr std::array kKinds{
        AttackKind{.name = "leaving",
                   .what = "an observer proposes that it leaves, without end",
                   .begin = beginLeaving,
                   .mostFacts = kComings},
        AttackKind{.name = "sharing",
                   .what = "a trainee shares ever more tubes, and hands them over to the host",
                   .begin = beginSharing,
                   .mostFacts = kComings + kSharing},
        AttackKind{.name = "breathing",
                   .what = "a trainee proposes breaths of the manikin without end",
                   .begin = beginBreathing,
                   .mostFacts = kComings,
                   .factsPerS = kBreathing},
        AttackKind{.name = "repeating",
                   .what = "a trainee proposes the place and the registration that it has",
                   .begin = beginRepeating,
                   .mostFacts = kComings + 1.0},
        AttackKind{.name = "impostor",
                   .what = "a trainee says Hello with the join of one who is present",
                   .begin = beginImpostor,
                   .mostFacts = kComings},
        AttackKind{.name = "false-token",
                   .what = "one says that it is a trainee who is present, whose name and number it "
                           "knows, without the token",
                   .begin = beginFalseToken,
                   .mostFacts = kComings},
        AttackKind{.name = "client-hellos",
                   .what = "ClientHellos without a cookie",
                   .begin = beginClientHellos,
                   .mostFacts = kComings},
        AttackKind{.name = "paths",
                   .what = "an observer opens paths and says no Hello",
                   .begin = beginIdlePaths,
                   .mostFacts = kComings,
                   .mostPaths = kIdlePaths,
                   .isElsewhere = true,
                   .keepsOut = true},
        AttackKind{.name = "false-tube",
                   .what = "a trainee streams a second tube, in time and 200 ms ahead of the "
                           "session, as its own and in the place of what others have",
                   .begin = beginFalseTube,
                   .mostFacts = kComings},
        AttackKind{.name = "shown",
                   .what = "a trainee tells without end where its tube was shown",
                   .begin = beginShowing,
                   .mostFacts = kComings + 1.0},
        AttackKind{.name = "crowd",
                   .what = "a trainee asks for tubes under twelve names, each within its budget",
                   .begin = beginCrowd,
                   .mostFacts = kComings + kCrowd,
                   .factsPerS = kCrowdPerS,
                   .leastPerS = kLeastOfMany,
                   .isElsewhere = true,
                   .keepsOut = true},
        AttackKind{.name = "strangers",
                   .what =
                       "datagrams over paths with an observer's code over which nobody comes in",
                   .begin = beginStrangers,
                   .mostFacts = kComings,
                   .mostPaths = kIdlePaths},
        AttackKind{.name = "actions",
                   .what = "a trainee acts on what is not its own, as its owner would",
                   .begin = beginForeignActions,
                   .mostFacts = kComings + 1.0},
        AttackKind{.name = "names",
                   .what = "a trainee comes in under 200 names, as fast as the host lets it, of "
                           "which 64 are there at a time",
                   .begin = beginNames,
                   .mostFacts = kComings + 2.0 * kNewNames,
                   .isElsewhere = true,
                   .needsRoom = true},
        AttackKind{.name = "garbage",
                   .what = "an observer sends bytes at random",
                   .begin = beginGarbage,
                   .mostFacts = kComings,
                   .factsPerS = kComingAgain,
                   .leastSent = kMany},
        AttackKind{.name = "instructing",
                   .what = "an instructor changes the patient and its breathing without end",
                   .begin = beginInstructing,
                   .mostFacts = kComings + 2.0 * kInstructing,
                   .factsPerS = kInstructing,
                   .leastPerS = kLeastInstructing},
        AttackKind{.name = "messages",
                   .what = "a trainee acts on what is not its own by messages of the strategy "
                           "\"none\", which the session has meanwhile",
                   .begin = beginForeignMessages,
                   .mostFacts = kComings + 1.0,
                   .strategy = StrategyKind::None},
        AttackKind{.name = "steady",
                   .what = "a trainee sends datagrams of every kind under eight names, as fast as "
                           "each may",
                   .begin = beginSteady,
                   .mostFacts = kComings + kSteady,
                   .leastSent = kMany},
        AttackKind{.name = "turns",
                   .what = "a trainee proposes under 24 names, of which four are there at a time, "
                           "as much as each may",
                   .begin = beginTurns,
                   .mostFacts = kComings + kTurns,
                   .factsPerS = kCrowdPerS,
                   .leastPerS = kLeastOfMany,
                   .keepsOut = true},
        AttackKind{.name = "hungry",
                   .what = "a trainee says without end that it has nothing of the log",
                   .begin = beginHungry,
                   .mostFacts = kComings + kOwn,
                   .factsPerS = kOwnPerS},
        AttackKind{.name = "together",
                   .what = "eighteen attackers at once, in all of these ways but \"messages\", "
                           "\"new-codes\", \"gallery\" and \"names\", which would hinder "
                           "the others",
                   .begin = beginTogether,
                   // All trainees share the budget of one address.
                   .mostFacts = double(kAttackersAtOnce) * kComings + kSharing + 2.0 * kInstructing
                                + kCrowd + kTurns + kSteady + kOwn,
                   .factsPerS = kBreathing + kInstructing + kCrowdPerS,
                   .leastPerS = 2.0 * kLeastOfMany,
                   .mostPaths = kIdlePaths,
                   .isAllOthers = true},
        AttackKind{
            .name = "gallery",
            .what = "a trainee shares four objects under each of 32 names, and streams all: more "
                    "than a station may have",
            .begin = beginGallery,
            .mostFacts = kComings + kGalleryNames * (2.0 + kGalleryObjects),
            .leastPerS = 2.0,
            .needsRoom = true},
        // Last: it takes the observers' code away.
        AttackKind{.name = "new-codes",
                   .what = "an instructor gives observers a new code without end",
                   .begin = beginNewCodes,
                   .mostFacts = kComings,
                   .factsPerS = 2.0,
                   .spoils = Role::Observer}};
    return kKinds;
}

} // namespace carina::lab
