#pragma once

#include "models/objects/shared_object_model.h"
#include "models/session/change_history.h"

#include <QPointer>

#include <array>
#include <map>
#include <optional>
#include <vector>

namespace carina
{

/// The actions of a person on the chosen shared object: rotate it about or translate it along an
/// axis of the anatomy frame A, or scale it, at constant speed until stopped; reset it to its
/// original pose, or put it back; and undo these, the last first, as long as nobody else has had
/// it since, also by the history of the session, whichever station is shown by then. Motion started
/// by other participants is shown as well.
class ObjectActionModel : public QObject
{
    Q_OBJECT

public:
    /// The range of an action's speed, and its unit.
    struct SpeedScale {
        double largest = 0.0; ///< largest magnitude, in either direction
        QString unit;         ///< "°/s"
    };
    enum class Axis : std::uint8_t { X, Y, Z };

    /// @pre object outlives this.
    explicit ObjectActionModel(SharedObjectModel& object, QObject* parent = nullptr);

    /// Adds its steps, and what changes hands, to a history from now on, by which alone they are to
    /// be undone.
    void setHistory(ChangeHistory& history);
    [[nodiscard]] bool hasHistory() const { return !m_history.isNull(); }

    [[nodiscard]] SharedObjectModel& object() const { return m_object; }

    // The settings of the action that start() begins.
    [[nodiscard]] ActionKind kind() const { return m_kind; }
    void setKind(ActionKind kind);
    [[nodiscard]] Axis axis() const { return m_axis; }
    void setAxis(Axis axis);
    [[nodiscard]] bool hasAxis() const { return m_kind != ActionKind::Scaling; }
    /// In the unit of the present kind; each kind keeps its own speed.
    [[nodiscard]] double speed() const { return m_speeds[std::size_t(m_kind)]; }
    void setSpeed(double speed);
    [[nodiscard]] static SpeedScale speedScale(ActionKind kind);

    [[nodiscard]] bool canStart() const; ///< false while this same action is already running
    [[nodiscard]] bool canStop() const;
    [[nodiscard]] bool canReset() const;
    /// Whether undo() would return it to where it was before this person's last step.
    [[nodiscard]] bool canUndo() const;
    /// Whether there is something that putAllBack() would put back.
    [[nodiscard]] bool canPutAllBack() const;

    /// The present motion, after its state mark: "● Turns about z at 100.0 °/s".
    [[nodiscard]] QString motionText() const;
    /// The displacement from its original pose: "Turned 42.0°, moved 0.0 mm, size 100.0 %".
    [[nodiscard]] QString placeText() const;
    [[nodiscard]] bool isInPlace() const;

public Q_SLOTS:
    void start();
    void stop();
    void reset();
    void undo();
    void putBack();
    /// Everything that this person may put back at the station, and the patient: an instructor
    /// takes it over for that, a trainee moves only their own. It is one change of the history. An
    /// undo brings this person's own back to where they were, and what others held back to them, in
    /// its original place: how they had moved it ended with its return.
    void putAllBack();

Q_SIGNALS:
    /// Anything of the above, or of the object, changed.
    void changed();

private:
    using Shown = std::array<QString, 2>;

    /// That can be undone, for each object: as many as a history may have of it.
    static constexpr std::size_t kMostSteps = ChangeHistory::kMost;

    [[nodiscard]] std::optional<ShownObject> shown() const;
    [[nodiscard]] std::optional<ShownObject> shownOf(ObjectId object) const;
    /// The patient, where it is not in its place and this person may put it back.
    [[nodiscard]] const SharedObject* strayPatient(const SessionState& state) const;
    /// @param what the step is, with %1 for the object
    void remember(ObjectId object, const QString& what);
    void undoOf(ObjectId object);
    void bringTo(ObjectId object, const ActedPose& pose);
    void forgetLost();
    void returnTaken();
    [[nodiscard]] QString stepText() const;
    [[nodiscard]] ObjectAction chosenAction() const;
    void act(const ObjectAction& action);
    void look();

    SharedObjectModel& m_object;
    ActionKind m_kind = ActionKind::Rotation;
    Axis m_axis = Axis::Z;
    std::array<double, 3> m_speeds{30.0, 10.0, 10.0}; ///< by ActionKind, each in its unit
    Shown m_told;                                     ///< at the latest changed()
    /// Where each object was before this person's steps, the last step last.
    std::map<ObjectId, std::vector<ActedPose>> m_steps;
    /// What is to be brought somewhere once it is this person's.
    struct Return {
        ObjectId object;
        std::uint16_t epoch = 0;     ///< of the ownership in which it is
        std::optional<ActedPose> to; ///< nothing: to its original place, which is a step
        ChangeHistory::Joint joint;  ///< of which that step is a part
    };
    std::vector<Return> m_returns;
    QPointer<ChangeHistory> m_history;
};

} // namespace carina
