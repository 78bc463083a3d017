#pragma once

#include "engine/session/respiration/respiration_follower.h"
#include "engine/session/session_state.h"

#include <map>
#include <vector>

namespace carina
{

/// A disease of a patient that has not come to rest yet.
struct Development {
    StationId station;
    LungCondition condition;
    /// Of the lung: closed by the gas in the pleural space, 0 to 0.95 (kLeastOpenShare stays open),
    /// or emptied by the blood, 0 to 1.
    double share = 0.0;
    /// Whether the gas has closed as much of the lung as it can, and only pushes on.
    bool isClosed = false;
    /// Of the mediastinum, to either side: the farthest in the last kGrowthTime.
    Length shift;

    friend bool operator==(const Development&, const Development&) = default;
};

/// Follows the diseases that take minutes at all open stations: a tension pneumothorax, whose gas
/// closes the lung first and then pushes the mediastinum aside, and the lung beside a tube in one
/// main bronchus, which the blood empties.
///
/// A disease develops as long as it grows by kLeastGrowth in kGrowthTime of breathing, so that one
/// whose tear lets no more gas in is not announced for ever. Growth is that of the share, and goes
/// on with the gas once it has closed the lung. A pause stops it, and is not counted.
class DevelopmentWatch
{
public:
    static constexpr double kGrowthTime = 10.0; ///< s
    static constexpr double kLeastGrowth = 0.004;

    /// What develops at a time; to be asked about once a second.
    /// @pre times do not decrease
    [[nodiscard]] std::vector<Development> at(const SessionState& state, SessionTime t);

private:
    struct Point {
        double breathed = 0.0; ///< s
        double share = 0.0;    ///< of a tear more than the lung where more gas came than it holds
        Length shift;
    };
    struct Course {
        LungCondition condition;
        std::vector<Point> points; ///< of the last kGrowthTime
    };
    struct Patient {
        RespirationFollower breathing;
        std::vector<Course> courses;
    };

    static void follow(Patient& patient, const Station& station, SessionTime t);
    static void add(Course& course, const Point& point);
    static bool develops(const Course& course);
    /// @pre it develops
    static Development developmentOf(StationId station, const Course& course);

    std::map<StationId, Patient> m_patients; ///< those that have such a disease
};

} // namespace carina
