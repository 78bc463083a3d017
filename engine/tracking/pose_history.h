#pragma once

#include "engine/tracking/prediction/motion_predictor.h"
#include "engine/tracking/prediction/one_euro_filter.h"
#include "engine/tracking/prediction/prediction.h"

#include <boost/circular_buffer.hpp>
#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

namespace carina
{

/// What is made of the samples of a tracker where they are drawn.
struct PoseTreatment {
    bool predicts = true; ///< poses beyond the newest sample are predicted; otherwise it is held
    bool smooths = false; ///< poses are those after a OneEuroFilter

    friend bool operator==(const PoseTreatment&, const PoseTreatment&) = default;
};

/// How a device D stands to the frame F in which its poses are wanted, and its stamps to the clock.
struct DevicePlace {
    RigidTransform X_FD{};
    Duration late{}; ///< it stamps the same moment so much later

    friend bool operator==(const DevicePlace& a, const DevicePlace& b)
    {
        return a.late == b.late && a.X_FD.translation() == b.X_FD.translation()
               && a.X_FD.rotation().coeffs() == b.X_FD.rotation().coeffs();
    }
};

/// The recent poses of one object O in one frame F. All functions are thread-safe: a device or
/// network thread pushes, any thread reads; each call locks one internal mutex.
///
/// For a time t, at() returns the sample of that time (Exact), the pose between two samples
/// (Interpolated: linear and slerp), or where the object is expected (Predicted).
///
/// Of a tracker's samples a MotionPredictor estimates the motion and a filtered pose, from which is
/// predicted (Limits::estimates). Otherwise the motion is that of the sample where its source gave
/// one; else the difference quotient to the previous tracked sample, if that is at most longestGap
/// older; else there is none and the pose stays constant. It is applied to the newest pose.
///
/// Samples are stored as they came. How a person wants them treated counts in shownAt() alone.
class PoseHistory
{
public:
    struct Limits {
        std::size_t capacity = 512;                           ///< number of samples stored
        Duration longestGap = std::chrono::milliseconds{150}; ///< longest gap that is interpolated
        Duration horizon = std::chrono::milliseconds{150};    ///< longest prediction
        bool estimates = false; ///< motions, from samples of a tracker that are pushed without
    };

    PoseHistory() = default;
    explicit PoseHistory(const Limits& limits) : m_limits{limits} {}

    /// Adds a sample, in order of time; it replaces a sample of the same time. When the history is
    /// full, the oldest sample is removed.
    /// @returns false where the sample was rejected: not finite, a time more than 100 years from
    ///          the clock's zero, or older than all samples of a full history.
    bool push(const PoseSample& measured);

    /// The pose at time t; nothing for a time before the oldest sample stored.
    ///
    /// Validity is Lost when a sample next to t is lost, when the samples around t are more than
    /// longestGap apart, or when t is more than horizon beyond the newest. The pose is then that of
    /// the sample before t, or the newest predicted up to the horizon, and has no motion. Between
    /// two samples the motion is their difference quotient, and validity and error are those of the
    /// worse sample. An Exact pose is the sample itself, with the motion described above.
    ///
    /// The deviation of a predicted pose, where the motion tells it, grows with the time since the
    /// newest sample, also beyond the horizon.
    [[nodiscard]] std::optional<PoseSample> at(SessionTime t) const;

    /// The pose to be drawn at time t: as at(), treated as a person wants it. The deviation of one
    /// that is held or smoothed includes how far it is from the one predicted.
    [[nodiscard]] std::optional<PoseSample> shownAt(SessionTime t) const;

    /// What is pushed from now on are poses X_DO of a device D, with its stamps; stored is X_FO.
    /// Samples that were stored while it was placed otherwise are removed.
    void placeDevice(const DevicePlace& place);
    /// X_FD of the device; nothing where it was not placed, and measures in F itself.
    [[nodiscard]] std::optional<RigidTransform> deviceFrame() const;

    /// How poses are treated from now on.
    void treat(const PoseTreatment& treatment);

    /// How good the predictions of the samples within a time before the newest were.
    [[nodiscard]] PredictionEffect effect(Duration ahead, Duration within) const;

    /// The newest sample; nothing while there is none.
    [[nodiscard]] std::optional<PoseSample> newest() const;

    /// All samples stored, oldest first.
    [[nodiscard]] std::vector<PoseSample> samples() const;

    /// Samples that were added since a cursor, in the order of their times, and the cursor for the
    /// next call. What was added before the first call is left out with the cursor of end().
    struct Added {
        std::vector<PoseSample> samples;
        std::uint64_t cursor = 0;
    };
    [[nodiscard]] Added since(std::uint64_t cursor) const;
    [[nodiscard]] std::uint64_t end() const;

    void clear();

private:
    struct Entry {
        PoseSample sample;
        std::uint64_t number = 0; ///< of all that were added
        RigidTransform filtered;  ///< from which is predicted
        RigidTransform smoothed;
    };

    static SessionTime timeOf(const Entry& entry) { return entry.sample.time; }

    // With the mutex locked.
    void forget();
    [[nodiscard]] Entry estimated(const PoseSample& sample);
    [[nodiscard]] PoseSample measured(std::size_t index, const PoseTreatment& treatment) const;
    [[nodiscard]] std::optional<PoseSample> treated(SessionTime t,
                                                    const PoseTreatment& treatment) const;
    [[nodiscard]] std::optional<Motion> motionOf(std::size_t index) const;
    [[nodiscard]] PoseSample carriedOn(std::size_t index, SessionTime t,
                                       const PoseTreatment& treatment) const;
    void predict(PoseSample& pose, const RigidTransform& X_FO, Duration ahead,
                 const PoseTreatment& treatment) const;

    Limits m_limits;
    std::optional<DevicePlace> m_place; ///< nothing: the device measures in F
    PoseTreatment m_treatment;
    MotionPredictor m_predictor;
    OneEuroFilter m_smoothing;
    mutable std::mutex m_mutex;
    boost::circular_buffer<Entry> m_entries; // ascending in time; one block of memory, or none
    std::uint64_t m_added = 0;
};

} // namespace carina
