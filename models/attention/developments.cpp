#include "models/attention/developments.h"

#include "engine/lungs/drawing/chest_shape.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace carina
{
namespace
{

/// Before a disease was watched for so long, it is taken to develop.
constexpr double kFirstLook_s = 4.0;

bool takesMinutes(ConditionKind kind)
{
    return kind == ConditionKind::TensionPneumothorax || kind == ConditionKind::MainstemIntubation;
}

bool affects(const LungCondition& condition, Side side)
{
    return condition.side == ConditionSide::Both
           || condition.side == (side == Side::Right ? ConditionSide::Right : ConditionSide::Left);
}

/// The gas that came through the tear, of what would close the whole lung.
double closedShare(const RespiratoryFold& fold, std::size_t lung)
{
    return fold.content()[lung].trapped.si / fold.system().lungs[lung].wallVolume.si;
}

/// The least share of a lung stays open, however much gas came.
double greatestShare(ConditionKind kind)
{
    return kind == ConditionKind::TensionPneumothorax ? 1.0 - kLeastOpenShare : 1.0;
}

/// How much the blood has taken of what it takes, at the end of expiration.
double emptiedShare(const RespiratoryFold& fold, std::size_t lung)
{
    const LungMechanics& mechanics = fold.system().lungs[lung];
    const double most = (mechanics.wallVolume - mechanics.uptakeEnd).si;
    if (mechanics.uptake.si == 0.0 || most <= 0.0)
        return 0.0;
    return (mechanics.wallVolume - fold.breath().least[lung]).si / most;
}

double shareOf(const LungCondition& condition, const RespiratoryFold& fold)
{
    const bool isTear = condition.kind == ConditionKind::TensionPneumothorax;
    double share = 0.0;
    for (const Side side : {Side::Right, Side::Left})
        if (affects(condition, side) == isTear) // a tube empties the lung that it is not in
            share = std::max(share, isTear ? closedShare(fold, lungIndex(side))
                                           : emptiedShare(fold, lungIndex(side)));
    return isTear ? share : std::min(share, 1.0);
}

Length shiftOf(const RespiratoryFold& fold)
{
    const ChestShape shape =
        chestShape(fold.settings().build, fold.system(), fold.content(), fold.moment());
    return {std::abs(shape.mediastinalShift.si)};
}

LungConditions slowOnes(const Station& station, SessionTime t)
{
    LungConditions slow;
    if (!station.closed)
        for (const LungCondition& condition : station.respiration.settingsAt(t).conditions)
            if (takesMinutes(condition.kind))
                slow.push_back(condition);
    return slow;
}

/// Whether it is the same disease, which may have become worse.
bool isSame(const LungCondition& a, const LungCondition& b)
{
    return a.kind == b.kind && a.side == b.side;
}

} // namespace

std::vector<Development> DevelopmentWatch::at(const SessionState& state, SessionTime t)
{
    std::vector<Development> all;
    for (const auto& [id, station] : state.stations()) {
        const LungConditions slow = slowOnes(station, t);
        if (slow.empty()) {
            m_patients.erase(id);
            continue;
        }
        Patient& patient = m_patients[id];
        std::vector<Course> courses;
        for (const LungCondition& condition : slow) {
            const auto known = std::ranges::find_if(patient.courses, [&](const Course& course) {
                return isSame(course.condition, condition);
            });
            courses.push_back(
                {condition, known == patient.courses.end() ? std::vector<Point>{} : known->points});
        }
        patient.courses = std::move(courses);
        follow(patient, station, t);
        for (const Course& course : patient.courses)
            if (develops(course))
                all.push_back(developmentOf(id, course));
    }
    return all;
}

Development DevelopmentWatch::developmentOf(StationId station, const Course& course)
{
    const ConditionKind kind = course.condition.kind;
    const double most = greatestShare(kind);
    const double share = course.points.back().share;
    return {station, course.condition, std::min(most, share),
            kind == ConditionKind::TensionPneumothorax && share >= most,
            std::ranges::max(course.points, {}, &Point::shift).shift};
}

void DevelopmentWatch::follow(Patient& patient, const Station& station, SessionTime t)
{
    const bool isKnown = std::ranges::none_of(
        patient.courses, [](const Course& course) { return course.points.empty(); });
    if (!station.respiration.runsAt(t) && isKnown)
        return;
    const RespiratoryFold& fold = patient.breathing.at(station.respiration, t).fold();
    if (!fold.hasBegun())
        return;
    const double breathed = double(fold.state().steps) * kRespiratoryStep;
    for (Course& course : patient.courses)
        add(course, {breathed, shareOf(course.condition, fold), shiftOf(fold)});
}

void DevelopmentWatch::add(Course& course, const Point& point)
{
    std::erase_if(course.points, [&](const Point& old) {
        return old.breathed < point.breathed - kGrowthTime || old.breathed >= point.breathed;
    });
    course.points.push_back(point);
}

bool DevelopmentWatch::develops(const Course& course)
{
    if (course.points.empty())
        return false;
    const Point& first = course.points.front();
    const Point& last = course.points.back();
    const double breathed = last.breathed - first.breathed;
    return breathed < kFirstLook_s
           || last.share - first.share >= kLeastGrowth * breathed / kGrowthTime;
}

} // namespace carina
