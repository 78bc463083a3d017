#pragma once

#include "models/objects/shared_object_model.h"

#include <array>

namespace carina
{

/// What a person does to the chosen shared object: turn it about, move it along one of the axes of
/// the anatomy frame, or scale it, at a steady speed until they stop; and bring it back to its
/// place. What goes on is shown whoever began it.
class ObjectActionModel : public QObject
{
    Q_OBJECT

public:
    /// How fast an action may be made to go, and in which unit.
    struct SpeedScale {
        double largest = 0.0; ///< in either direction
        QString unit;         ///< "°/s"
    };
    enum class Axis : std::uint8_t { X, Y, Z };

    /// @pre object outlives this.
    explicit ObjectActionModel(SharedObjectModel& object, QObject* parent = nullptr);

    [[nodiscard]] SharedObjectModel& object() const { return m_object; }

    // The action that start() takes.
    [[nodiscard]] ActionKind kind() const { return m_kind; }
    void setKind(ActionKind kind);
    [[nodiscard]] Axis axis() const { return m_axis; }
    void setAxis(Axis axis);
    [[nodiscard]] bool hasAxis() const { return m_kind != ActionKind::Scaling; }
    /// Of the kind, in its unit; each kind keeps its own.
    [[nodiscard]] double speed() const { return m_speeds[std::size_t(m_kind)]; }
    void setSpeed(double speed);
    [[nodiscard]] static SpeedScale speedScale(ActionKind kind);

    [[nodiscard]] bool canStart() const; ///< not where just this goes on already
    [[nodiscard]] bool canStop() const;
    [[nodiscard]] bool canReset() const;

    /// What goes on, with a shape: "● Turns about z at 100.0 °/s".
    [[nodiscard]] QString motionText() const;
    /// Where it is against its place: "Turned 42.0°, moved 0.0 mm, size 100.0 %".
    [[nodiscard]] QString placeText() const;
    [[nodiscard]] bool isInPlace() const;

public Q_SLOTS:
    void start();
    void stop();
    void reset();

Q_SIGNALS:
    /// Anything of the above, or of the object, changed.
    void changed();

private:
    using Shown = std::array<QString, 2>;

    [[nodiscard]] std::optional<ShownObject> shown() const;
    [[nodiscard]] ObjectAction chosenAction() const;
    void act(const ObjectAction& action);
    void look();

    SharedObjectModel& m_object;
    ActionKind m_kind = ActionKind::Rotation;
    Axis m_axis = Axis::Z;
    std::array<double, 3> m_speeds{30.0, 10.0, 10.0}; ///< per kind, in its unit
    Shown m_told;                                     ///< at the latest signal
};

} // namespace carina
