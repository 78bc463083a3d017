#pragma once

#include "apps/lab/intubation/intubation_trial.h"

#include <QJsonArray>
#include <QJsonObject>

#include <array>

namespace carina::lab
{

/// What many trials of one patient gave.
class TrialStatistics
{
public:
    void add(const IntubationTrial& trial);

    /// As `carina-lab intubate --all-scripts` prints it.
    [[nodiscard]] QJsonObject report(const IntubationSubject& subject) const;

    static constexpr double kSure = 0.8;                     ///< a confidence; of ours
    static constexpr Length kDepthWithin = millimetres(3.0); ///< beside the registration
    static constexpr Duration kTimeWithin = std::chrono::milliseconds{100};

private:
    static constexpr std::size_t kSeats = kTubeSeats.size();

    /// Magnitudes of errors, and how many of them are within their bound.
    struct Errors {
        std::vector<double> sizes;
        int within = 0;

        void add(double size, double bound);
    };

    void addDepth(const IntubationTrial& trial);
    void addTimes(const IntubationTrial& trial);
    [[nodiscard]] QJsonArray confusion() const;
    [[nodiscard]] static QJsonObject lengthsOf(const Errors& errors);
    [[nodiscard]] QJsonObject times() const;

    int m_runs = 0;
    int m_outside = 0;
    int m_wrong = 0;
    int m_wrongUnsure = 0;
    int m_frozen = 0; ///< with the right outcome, that tell no depth
    int m_rightSure = 0;
    int m_wrongAttempts = 0;
    int m_missed = 0;
    int m_invented = 0;
    std::array<std::array<int, kSeats>, kSeats> m_seen{}; ///< by truth, then by outcome
    Errors m_depth;
    Errors m_carina;
    Errors m_times;
    QJsonArray m_wrongRuns;
};

} // namespace carina::lab
