#pragma once

#include "models/lesson/shared_pose.h"
#include "models/session/change_history.h"
#include "models/session/session_model.h"
#include "models/station/people_poses.h"

#include <QPointer>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace carina
{

/// What an instructor shows to others at a station: their own picture of the patient, from where
/// they look if they want that, and what they point at; to everybody there or to one of them. One
/// switch, which everything follows while it is on. Lives on the GUI thread.
class LessonModel : public QObject
{
    Q_OBJECT

public:
    struct Target {
        ParticipantId id; ///< kNobody: everybody
        QString name;

        friend bool operator==(const Target&, const Target&) = default;
    };

    /// Shortest time between two pictures that are shown: each is a fact and stays in the log.
    static constexpr Duration kShortestPause = std::chrono::milliseconds{250};

    /// @pre session outlives this.
    LessonModel(SessionModel& session, StationId station, QObject* parent = nullptr);

    /// Speaks of another station from now on. What is shown at the former one stays as it is,
    /// without following anything, and so does what can be undone about it. Back at a station,
    /// switch and choices are as they were, and what ended there because this person went to
    /// another station is shown again, while the same patient lies there and they have switched on
    /// nothing elsewhere.
    void setStation(StationId station);
    /// Adds its changes to a history from now on, by which they are undone.
    void setHistory(ChangeHistory& history) { m_history = &history; }

    /// To whom something can be shown, everybody first.
    [[nodiscard]] std::vector<Target> targets() const;
    /// To whom it is shown; everybody, if the one who was chosen has left.
    [[nodiscard]] ParticipantId target() const;
    void setTarget(ParticipantId target);
    /// Whether others look from where this person does.
    [[nodiscard]] bool showsView() const { return m_showsView; }
    void setShowsView(bool shows);

    /// Whether this person shows something now.
    [[nodiscard]] bool isOn() const;
    [[nodiscard]] bool canSwitch() const;
    void setOn(bool on);
    /// What this person showed at this station and did not end (Station::brokenOff); nothing once
    /// something is shown there again.
    [[nodiscard]] std::optional<ShownLesson> brokenOff() const;
    /// Whether showAgain would show it.
    [[nodiscard]] bool canShowAgain() const;
    /// Shows that again, to whom it was shown. Whoever calls follow() makes the picture so first.
    void showAgain();
    /// What is shown to whom, after its mark, and what the pointer is: "● Shown to everybody:
    /// section, names; your mouse over the picture is the pointer". Empty while nothing is.
    [[nodiscard]] QString text() const;
    /// What this person shows at a station that this does not speak of: "● Still shown at Room 5 to
    /// everybody: section". Empty while they do not.
    [[nodiscard]] QString elsewhereText() const;

    /// The picture as this person has it now, which is shown while this is on, at most every
    /// kShortestPause; to be called again and again. Its showsView has no effect.
    void follow(const Lesson& picture);
    /// Where this person looks from now: X_AD. To be called again and again.
    void lookFrom(const RigidTransform& X_AD);
    /// What they point with, which rests there until this is called again: the tip at the origin,
    /// pointing along -z; nothing: they do not.
    void pointWith(const std::optional<RigidTransform>& X_AP);
    /// The pointer while this is on, for this program's own picture.
    [[nodiscard]] ObjectPoses poses() const;

Q_SIGNALS:
    void changed();

private:
    /// What the switch and its choices are.
    struct Setting {
        bool on = false;
        ParticipantId to = kNobody;
        bool showsView = true;
    };

    /// What is kept of a station while this speaks of another one.
    struct Left {
        Setting setting;
        Lesson picture;
        std::string patient; ///< that lay there, by its content hash
    };

    [[nodiscard]] const ShownLesson* shown(const SessionState& state, StationId station) const;
    [[nodiscard]] std::string patientAt(StationId station) const;
    [[nodiscard]] Setting setting() const;
    void change(const Setting& wanted);
    void apply(const Setting& wanted);
    void takeBack(StationId station, const Setting& before);
    void show(StationId station, const Setting& wanted, Lesson picture);
    void comeBack();
    [[nodiscard]] bool hasEndedByGoing(const Setting& left) const;
    void pause();
    void shareOnce();
    void withdraw();
    void come();
    [[nodiscard]] QString nameOf(ParticipantId target) const;
    [[nodiscard]] QString changeText(const Setting& wanted) const;
    [[nodiscard]] std::optional<PoseSample> poseNow(const RigidTransform& X_AO) const;

    SessionModel& m_session;
    QPointer<ChangeHistory> m_history;
    StationId m_station;
    ParticipantId m_target = kNobody;
    bool m_showsView = true;
    bool m_isShared = false;
    Lesson m_picture;
    std::map<StationId, Left> m_left;
    SessionTime m_nextPicture = SessionTime::min();
    // Shared with the node's thread, which reads them.
    std::shared_ptr<SharedPose> m_view = std::make_shared<SharedPose>();
    std::shared_ptr<SharedPose> m_pointer = std::make_shared<SharedPose>();
};

} // namespace carina
