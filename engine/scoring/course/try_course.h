#pragma once

#include "engine/scoring/course/blade_samples.h"
#include "engine/scoring/course/told_place.h"
#include "engine/scoring/course/try_metrics.h"

#include <optional>
#include <utility>
#include <vector>

namespace carina
{

/// Follows one try at intubating, from the blade or tube that passes the teeth to its end, with a
/// bounded memory: no try lasts longer than kLongestTry, and of one no more than kMostEvents events
/// are kept. No time counts while the session is paused.
///
/// A try ends by itself kVentilatedFor after the first breath into a lung, or after a person said
/// last where the tube is, so that no end is set back; once tube and blade have
/// left the mouth for kOutFor, at the time when they left it; or after kLongestTry.
/// A tube in the oesophagus does not end it:
/// whether it is recognised is part of it. A person may end it at any time.
class TryCourse
{
public:
    static constexpr Duration kVentilatedFor = std::chrono::seconds{20}; ///< some breaths; of ours
    static constexpr Duration kOutFor = std::chrono::seconds{10};        ///< of ours
    static constexpr Duration kLongestTry = std::chrono::minutes{10};    ///< of ours
    static constexpr std::size_t kMostEvents = 1000;                     ///< of ours

    /// @param up_F  the direction against gravity in the frame of all poses, of length 1
    explicit TryCourse(const Vec3& up_F);

    /// Those that are known by now; before anything else is added that comes behind one.
    void setPauses(Pauses pauses) { m_pauses = std::move(pauses); }
    /// The next event, in the order in which they were noted. Before the first one that
    /// beginsTry(), all are ignored.
    void add(const IntubationEvent& event);
    /// A person says where the tube in the mouth is, or says it no more (courseAsTold): also before
    /// the try begins, and when it has ended, of the end.
    void tell(std::optional<TubeSeat> seat, SessionTime since);
    void addVitals(SessionTime t, const Vitals& vitals);
    /// Counts where the blade is in the mouth at that time, which may be known later. Samples from
    /// before the try count, too, from the first step on.
    void addBlade(const PoseSample& X_FL);
    void addHead(const PoseSample& X_FH);
    /// Where a blade in the mouth is known to press, or not to.
    void addForces(SessionTime t, Force incisors, Force tongue);
    /// How far the head is extended; the first after the try began counts.
    void addHeadExtension(Angle extension);
    /// Its begin was not watched: what is measured on the way is not told then, but what events
    /// tell.
    void beganBefore() { m_isWatched = false; }
    void check(TryCheck what, bool isDone) { m_checks[static_cast<std::size_t>(what)] = isDone; }

    [[nodiscard]] bool hasBegun() const { return !m_events.empty(); }
    /// When the try ended by itself; nothing while it goes on.
    /// @param now nothing that happened until then will be added any more
    [[nodiscard]] std::optional<SessionTime> endedBy(SessionTime now) const;

    /// What was measured until the end; of plane, hand and forces also what was measured before it
    /// was known that the try had ended, where a person said later what makes its end an earlier
    /// one.
    /// @param depthWanted by the scenario's rule; nothing where none holds
    /// @pre hasBegun()
    [[nodiscard]] TryMetrics metrics(SessionTime ended, std::optional<Length> depthWanted) const;

private:
    void follow(const IntubationEvent& event);
    [[nodiscard]] bool isWithinLongest(SessionTime t) const;
    [[nodiscard]] bool wasPausedBetween(SessionTime from, SessionTime until) const;
    void measure(const std::vector<PoseSample>& blade);

    Vec3 m_up_F;
    Pauses m_pauses;
    std::vector<IntubationEvent> m_events; ///< as they were noted
    std::vector<ToldSeat> m_told;
    bool m_bladeIsIn = false;
    bool m_tubeIsIn = false;
    SessionTime m_leftAt = SessionTime::min(); ///< the later of blade and tube left the mouth
    std::optional<SessionTime> m_outSince;     ///< of tube and blade
    std::optional<SessionTime> m_firstBreath;  ///< into a lung
    // All of it, as an end is known later than it was, and may be set back by what a person says.
    std::vector<std::pair<SessionTime, Vitals>> m_vitals;
    std::vector<PoseSample> m_heads;
    ForceMeter m_incisors{kIncisorLimits};
    ForceMeter m_tongue{kTongueLimits};
    std::optional<SessionTime> m_lastForces;
    BladeSamples m_blade;
    std::optional<SessionTime> m_lastBlade; ///< in the mouth
    PlaneMeter m_plane;
    MotionMeter m_hand;
    bool m_isWatched = true; ///< from its begin on
    std::optional<Angle> m_headExtension;
    std::array<std::optional<bool>, kTryChecks> m_checks{};
};

} // namespace carina
