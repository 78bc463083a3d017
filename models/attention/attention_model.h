#pragma once

#include "models/attention/developments.h"
#include "models/objects/object_hand_over.h"
#include "models/session/session_model.h"
#include "models/station/tool_status.h"

#include <QString>

#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace carina
{

class SessionPatient;

/// What may need an instructor's attention, the most urgent first.
enum class Concern : std::uint8_t {
    Refused,        ///< the host refused what was done here
    TwoPrograms,    ///< two programs had one participant's token
    Asked,          ///< somebody asks for an object
    TubePlace,      ///< a tube is not in the trachea, or nothing tells where it is
    Away,           ///< a participant's program is not heard of, and they did not leave
    Unseen,         ///< a tool of a participant is not seen by their tracker
    Tracker,        ///< that of this program does not track
    NoPatient,      ///< the session's patient is not on this computer
    Registration,   ///< cannot be relied on
    Clock,          ///< a clock that NTP or PTP disciplines contradicts the path
    BrokenOff,      ///< others are no longer shown what this program showed before it stopped
    BreathingStops, ///< over a time
    Developing,     ///< a disease
};

struct Attention {
    Concern concern = Concern::Refused;
    QString text;   ///< a line: what is the matter
    QString action; ///< the word on its button
    StationId station = kNoStation;
    ParticipantId participant = kNobody;
    ObjectId object{};
    bool canBeDismissed = false; ///< besides what its action does

    friend bool operator==(const Attention&, const Attention&) = default;
};

/// Whether both are about the same matter, whatever has become of it.
[[nodiscard]] bool isSameMatter(const Attention& a, const Attention& b);

/// Everything in a session that needs an instructor's attention, at all stations, with what can be
/// done about it. Lives on the GUI thread.
class AttentionModel : public QObject
{
    Q_OBJECT

public:
    /// A tool that is hidden for less, as by a hand, is not told.
    static constexpr Duration kUnseenTold = std::chrono::seconds{2};
    /// So long a replaced token is told.
    static constexpr Duration kReplacedTold = std::chrono::minutes{1};
    /// So long it is told that something is no longer shown.
    static constexpr Duration kBrokenOffTold = std::chrono::minutes{5};
    static constexpr int kAttentionLook_ms = 500;

    /// @pre session outlives this.
    explicit AttentionModel(SessionModel& session, QObject* parent = nullptr);

    /// Tells from now on also what keeps this patient away. @pre it outlives this.
    void setPatient(SessionPatient& patient);
    /// How the tracker of this program sees its tools now; std::nullopt while it has none.
    using OwnTracker = std::function<std::optional<TrackerSight>()>;
    /// Tells from now on also what keeps this program's tracker, or a tool of it, from tracking.
    void setTracker(OwnTracker tracker);

    /// Adds what is given to who asks for it to a history from now on.
    void setHistory(ChangeHistory& history) { m_handOver.setHistory(history); }

    /// The most urgent first; of one concern, by station and participant.
    [[nodiscard]] const std::vector<Attention>& all() const { return m_all; }
    /// Does what the action says, or asks by showWanted for the place where it can be done. Nothing
    /// where the matter is settled already.
    void act(const Attention& attention);
    /// Tells no more of a matter that can be dismissed, unless it comes up anew.
    void dismiss(const Attention& attention);

    /// Looks again; a timer calls it.
    void look();

Q_SIGNALS:
    void changed();
    /// The place where this matter is seen and settled is to be shown.
    void showWanted(const carina::Attention& attention);

private:
    using Reports = std::vector<Attention>;

    [[nodiscard]] Reports current();
    void addRefusal(Reports& all);
    [[nodiscard]] bool isBeingGiven(ObjectId object) const;
    void addRequests(const SessionState& state, Reports& all) const;
    void addPeople(const SessionState& state, SessionTime now, bool hasTracker, Reports& all);
    void addUnseen(const SessionState& state, const Participant& who, SessionTime now,
                   Reports& all);
    void addBrokenOff(const SessionState& state, SessionTime now, Reports& all) const;
    void addPatient(Reports& all) const;
    void addTracker(const SessionState& state, const TrackerSight& sight, Reports& all) const;
    static void addTubes(const SessionState& state, SessionTime now, Reports& all);
    void addBreathing(const SessionState& state, SessionTime now, Reports& all);
    [[nodiscard]] bool isAway(ParticipantId participant) const;
    [[nodiscard]] bool isMissed(const Participant& who) const;
    void missNoLonger(const Attention& away);
    [[nodiscard]] bool hasWrongClock(ParticipantId participant) const;
    [[nodiscard]] bool isUnseen(ObjectId object, SessionTime now);
    void give(const Attention& asked);

    SessionModel& m_session;
    ObjectHandOver m_handOver;
    SessionPatient* m_patient = nullptr;
    OwnTracker m_tracker; ///< may be empty
    DevelopmentWatch m_developments;
    std::vector<Development> m_developing;
    std::optional<SessionTime> m_developmentsAt;
    std::map<ObjectId, SessionTime> m_unseenSince;
    std::optional<Error> m_dismissed; ///< the refusal that was read
    /// When what broke off did so that is told no more.
    std::map<StationId, SessionTime> m_notShownAgain;
    /// Who is missed no longer, and when they fell silent.
    std::map<ParticipantId, SessionTime> m_notMissed;
    Reports m_all;
};

} // namespace carina
