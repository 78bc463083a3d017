#pragma once

#include "engine/airway/monitor/intubation_event.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace carina
{

/// What a person said in the course of a try of where the tube in the mouth is.
struct ToldSeat {
    std::size_t after = 0;          ///< so many events had been noted
    SessionTime since{};            ///< when it was said
    std::optional<TubeSeat> seat{}; ///< nothing: where the monitor notes it

    friend bool operator==(const ToldSeat&, const ToldSeat&) = default;
};

/// The course of a try in which what a person said takes the place of what a monitor concluded.
///
/// It is followed from passage to passage of the tip through the level of the cords, by the
/// monitor. What is in force at the end of such a part holds in all of it, since the tip came
/// there: what was said before in the same part leaves nothing behind, nor does what was taken
/// back. Where the monitor has the tip above the cords, what is said there holds since something
/// was said of it. What the monitor notes of the way is left out then, but for the depth, and all
/// else is told of the place that the person named. The first breath in a part is that of the place
/// of this part.
///
/// What was said ends with the part before the tube is noted to be out of the mouth, or with that
/// step where it was said in this part.
/// @param noted in the order in which they were noted
/// @param told in the order in which it was said
[[nodiscard]] std::vector<IntubationEvent> courseAsTold(std::span<const IntubationEvent> noted,
                                                        std::span<const ToldSeat> told);

/// What a person says at the end of the events.
[[nodiscard]] std::optional<TubeSeat> toldAtEnd(std::span<const IntubationEvent> noted,
                                                std::span<const ToldSeat> told);

} // namespace carina
