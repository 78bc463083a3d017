#include "engine/session/lesson_rules.h"

#include "engine/session/facts/number_check.h"

#include <cmath>
#include <string>

namespace carina
{
namespace
{

constexpr double kRounding = 1e-6; ///< of the length of a normal

Result<void> checkSection(const LessonSection& section)
{
    double squared = 0.0;
    for (const double component : section.normal_A)
        squared += component * component;
    return checkNumber("length of a section's normal", std::sqrt(squared), 1.0 - kRounding,
                       1.0 + kRounding, "")
        .and_then([&] {
            return checkNumber("distance of a section", section.distance, -kFarthestSection,
                               kFarthestSection, " m");
        });
}

Result<void> checkLooks(const LessonLooks& looks)
{
    unsigned before = 0;
    for (const LessonLook& look : looks) {
        if (look.first <= before || look.last < look.first)
            return fail(Errc::OutOfRange, "the order of the parts that a lesson shows");
        before = look.last;
    }
    return looks.size() > kMostLessonLooks
               ? fail(Errc::OutOfRange, std::to_string(looks.size()) + " looks of parts")
               : Result<void>{};
}

Result<void> checkTarget(const SessionState& state, ParticipantId to)
{
    if (to == kNobody)
        return {};
    const auto known = state.participants().find(to);
    if (known == state.participants().end())
        return fail(Errc::OutOfRange, "participant " + std::to_string(to.value));
    return known->second.role == Role::Instructor ? fail(Errc::NotPermitted, known->second.name)
                                                  : Result<void>{};
}

} // namespace

Result<void> checkLesson(const Lesson& lesson)
{
    return checkSection(lesson.section).and_then([&] { return checkLooks(lesson.looks); });
}

Result<void> checkLessons(const SessionState& state, StationId station, const FactBody& body)
{
    if (const auto* shown = std::get_if<fact::LessonShown>(&body))
        return checkTarget(state, shown->to);
    if (!std::holds_alternative<fact::LessonEnded>(body))
        return {};
    return state.stations().at(station).lesson
               ? Result<void>{}
               : fail(Errc::OutOfRange, "nothing is shown that could be ended");
}

const ShownLesson* lessonFor(const SessionState& state, ParticipantId participant)
{
    const auto station = state.stations().find(state.stationOf(participant));
    if (station == state.stations().end() || !station->second.lesson)
        return nullptr;
    const ShownLesson& shown = *station->second.lesson;
    const bool isMeant = shown.to == kNobody || shown.to == participant;
    return isMeant && shown.by != participant ? &shown : nullptr;
}

} // namespace carina
