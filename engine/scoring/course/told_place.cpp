#include "engine/scoring/course/told_place.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace carina
{
namespace
{

using Told = std::optional<TubeSeat>;

/// Above the cords, in the airway or in the oesophagus.
TubeSeat wayOf(TubeSeat seat) { return isInMainBronchus(seat) ? TubeSeat::Trachea : seat; }

/// Events between two passages of the level of the cords, by their indices.
struct Part {
    std::size_t begin = 0;
    std::size_t end = 0;
    bool isAboveCords = false;
    bool isTubeOut = false; ///< its last event
};

std::vector<Part> partsOf(std::span<const IntubationEvent> noted)
{
    std::vector<Part> parts;
    for (std::size_t i = 0; i < noted.size(); ++i) {
        const TubeSeat way = wayOf(noted[i].seat);
        if (parts.empty() || parts.back().isTubeOut || way != wayOf(noted[i - 1].seat))
            parts.push_back({i, i, way == TubeSeat::None, false});
        parts.back().end = i + 1;
        parts.back().isTubeOut = noted[i].step == IntubationStep::TubeOut;
    }
    return parts;
}

/// What holds in a part: before an event, and from it on.
struct Holding {
    Told first;
    Told then;
    std::size_t from = 0; ///< index of the first event of `then`
    SessionTime since{};  ///< when that begins
};

/// Writes a course.
class CourseWriter
{
public:
    /// The tip is somewhere else. @param like what else was measured then
    void go(TubeSeat to, SessionTime at, const IntubationEvent& like)
    {
        const TubeSeat from = m_seat.value_or(to);
        m_seat = to;
        if (from == to)
            return;
        const auto step = [&](IntubationStep what, TubeSeat seat) {
            m_course.push_back(like);
            m_course.back().step = what;
            m_course.back().at = at;
            m_course.back().seat = seat;
        };
        if (from == TubeSeat::Oesophagus)
            step(IntubationStep::OutOfOesophagus, TubeSeat::None);
        if (isInMainBronchus(from))
            step(IntubationStep::BackAboveCarina, TubeSeat::Trachea);
        if (isThroughCords(from) && !isThroughCords(to))
            step(IntubationStep::BackAboveCords, TubeSeat::None);
        if (to == TubeSeat::Oesophagus)
            step(IntubationStep::InOesophagus, TubeSeat::Oesophagus);
        if (isThroughCords(to) && !isThroughCords(from))
            step(IntubationStep::ThroughCords, TubeSeat::Trachea);
        if (isInMainBronchus(to))
            step(IntubationStep::PastCarina, to);
    }
    /// As the monitor notes it. @param before where it had the tip until then
    void note(const IntubationEvent& event, TubeSeat before)
    {
        const bool isAsBefore = m_seat.value_or(before) == before;
        if (!isAsBefore)
            go(event.seat, event.at, event);
        if (isAsBefore || !isOfWay(event.step))
            m_course.push_back(event);
        m_seat = event.seat;
    }
    /// As a person says it.
    void tell(IntubationEvent event, TubeSeat seat)
    {
        event.seat = seat;
        event.confidence = 1.0;
        go(seat, event.at, event);
        if (isOfWay(event.step))
            event.step = IntubationStep::AtRest;
        m_course.push_back(event);
    }
    [[nodiscard]] std::vector<IntubationEvent> take() { return std::move(m_course); }

private:
    std::vector<IntubationEvent> m_course;
    std::optional<TubeSeat> m_seat; ///< nothing before the first event
};

/// Goes through a try once.
class Teller
{
public:
    Teller(std::span<const IntubationEvent> noted, std::span<const ToldSeat> told)
        : m_noted{noted}, m_told{told}
    {
        for (const Part& part : partsOf(noted))
            tell(part);
    }
    [[nodiscard]] std::vector<IntubationEvent> course() { return m_writer.take(); }
    [[nodiscard]] const Told& atEnd() const { return m_held; }

private:
    void tell(const Part& part);
    [[nodiscard]] Holding holdingIn(const Part& part) const;
    [[nodiscard]] std::vector<ToldSeat> saidIn(const Part& part) const;
    void begin(const Holding& holding);
    void write(std::size_t i, const Told& told);

    std::span<const IntubationEvent> m_noted;
    std::span<const ToldSeat> m_told;
    CourseWriter m_writer;
    Told m_held; ///< at the end of the part before
};

void Teller::tell(const Part& part)
{
    const Holding holding = holdingIn(part);
    bool hadBreath = false;
    for (std::size_t i = part.begin; i < part.end; ++i) {
        if (i == holding.from && i > part.begin) {
            begin(holding);
            hadBreath = false;
        }
        const bool isBreath = m_noted[i].step == IntubationStep::FirstBreath;
        if (!isBreath || !std::exchange(hadBreath, true)) // another is of another place
            write(i, i < holding.from ? holding.first : holding.then);
    }
    if (holding.from == part.end)
        begin(holding);
    m_held = part.isTubeOut ? Told{} : holding.then;
}

Holding Teller::holdingIn(const Part& part) const
{
    const Told before = part.isAboveCords && part.isTubeOut ? Told{} : m_held;
    const std::vector<ToldSeat> said = saidIn(part);
    if (said.empty())
        return {before, before, part.begin, {}};
    const Told last = said.back().seat;
    if (!part.isAboveCords)
        return {last, last, part.begin, {}};
    // What is corrected holds since it was said first, as its breath was one of it.
    auto first = std::prev(said.end());
    while (last && first != said.begin() && std::prev(first)->seat)
        --first;
    return {before, last, std::max(first->after, part.begin), first->since};
}

std::vector<ToldSeat> Teller::saidIn(const Part& part) const
{
    std::vector<ToldSeat> found;
    for (const ToldSeat& said : m_told) {
        const std::size_t newest = std::max<std::size_t>(said.after, 1) - 1; // event
        const bool isOfTube = !part.isTubeOut || newest + 1 < part.end;
        if (newest >= part.begin && newest < part.end && isOfTube)
            found.push_back(said);
    }
    return found;
}

/// What was said above the cords.
void Teller::begin(const Holding& holding)
{
    IntubationEvent newest = m_noted[holding.from - 1];
    if (holding.then)
        newest.confidence = 1.0;
    m_writer.go(holding.then.value_or(newest.seat), holding.since, newest);
}

void Teller::write(std::size_t i, const Told& told)
{
    const IntubationEvent& event = m_noted[i];
    if (told && event.step != IntubationStep::TubeOut)
        m_writer.tell(event, *told);
    else
        m_writer.note(event, m_noted[i > 0 ? i - 1 : 0].seat);
}

} // namespace

std::vector<IntubationEvent> courseAsTold(std::span<const IntubationEvent> noted,
                                          std::span<const ToldSeat> told)
{
    return Teller{noted, told}.course();
}

std::optional<TubeSeat> toldAtEnd(std::span<const IntubationEvent> noted,
                                  std::span<const ToldSeat> told)
{
    return Teller{noted, told}.atEnd();
}

} // namespace carina
