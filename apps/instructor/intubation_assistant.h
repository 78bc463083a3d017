#pragma once

#include "apps/program/played_intubation.h"
#include "engine/net/node/session_node.h"

#include <QTimer>

#include <cstdint>
#include <map>

namespace carina
{

/// Who assists at an intubation that a trainee's program plays: proposes, as an instructor, what
/// this person does around who holds tube and laryngoscope, from when the session runs and somebody
/// is at work at the station.
///
/// Pure oxygen by a mask at once; after kPreoxygenation drugs in their usual doses, and the bag by
/// mask. When the monitor notes the blade in the mouth, mask and bag are taken away. kToBreath
/// after it notes that the cuff is inflated the bag is squeezed again, wherever the tube is, and
/// rests when the cuff is empty or the tube is out. With MotionKind::NeckFlexed the neck is flexed
/// kToFlexion after the first breath. All these times are of ours, in running time.
class IntubationAssistant
{
public:
    static constexpr Duration kPreoxygenation = std::chrono::seconds{15};
    static constexpr Duration kToBreath = std::chrono::seconds{2};
    static constexpr Duration kToFlexion = std::chrono::seconds{5};
    static constexpr Duration kFlexes = std::chrono::milliseconds{1500}; ///< how long that takes

    /// @pre node outlives this.
    IntubationAssistant(SessionNode& node, StationId station,
                        const program::PlayedIntubation& played);

    /// Does what is due; a timer calls it ten times a second.
    void look();

private:
    enum class Act : std::uint8_t { Induce, SqueezeBag, FlexNeck };

    [[nodiscard]] const Station* stationIn(const SessionState& state) const;
    void hear(const Station& station, Duration running);
    void hear(IntubationStep step, Duration running);
    void perform(Act act, const Station& station, SessionTime now);
    void holdMask(bool held);
    void squeezeBag(const PatientBuild& build);
    void restBag();
    void induce(const PatientBuild& build);

    SessionNode& m_node;
    StationId m_station;
    program::PlayedIntubation m_played;
    bool m_hasBegun = false;
    bool m_isBagSqueezed = false;
    std::map<Act, Duration> m_due; ///< in running time
    std::uint64_t m_heard = 0;     ///< number of the last entry that was heard
    QTimer m_looking;
};

} // namespace carina
