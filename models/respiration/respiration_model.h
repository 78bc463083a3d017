#pragma once

#include "engine/lungs/mechanics/lung_condition.h"
#include "engine/lungs/mechanics/ventilation.h"
#include "engine/session/facts/fact_rules.h"
#include "engine/session/respiration/respiration_rules.h"
#include "models/session/session_model.h"

#include <array>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace carina
{

/// What ails one station's patient, how it lies, who breathes it and through what, as an instructor
/// sees and changes it.
///
/// A change travels to every site before it takes effect; until then `shown` already has it and
/// `travellingText` tells it. While one change of a thing is under way only the latest further one
/// is kept, so that dragging a severity never piles up facts. Others than instructors see what
/// there is; what they set goes nowhere.
class RespirationModel : public QObject
{
    Q_OBJECT

public:
    /// @pre session outlives this.
    RespirationModel(SessionModel& session, StationId station, QObject* parent = nullptr);

    // Asked for, or where nothing is, in force.
    [[nodiscard]] LungCondition condition() const;
    [[nodiscard]] VentilatorSettings ventilator() const;
    [[nodiscard]] Length tube() const; ///< inner diameter; 0 without one
    [[nodiscard]] BodyPosition position() const;

    /// With the severity there was, or half of it; of one lung where it usually is of one, the one
    /// there was or the right.
    void choose(ConditionKind kind);
    /// A tube in a main bronchus is in one of them: the right one, unless a side is said.
    void setCondition(LungCondition condition);
    void setVentilator(const VentilatorSettings& settings) { set(settings); }
    void setTube(Length innerDiameter) { set(innerDiameter); }
    void setPosition(BodyPosition position) { set(position); }

    /// What ails the patient now and, unless on the back, how it lies: "COPD, severity 0.60, both
    /// lungs; prone".
    [[nodiscard]] QString inForceText() const;
    /// The changes that travel, one a line: "Condition → COPD, severity 0.60, both lungs"; empty
    /// when none does.
    [[nodiscard]] QString travellingText() const;
    /// Why the person here can change nothing, as a sentence; empty where they can.
    [[nodiscard]] QString obstacle() const;

    [[nodiscard]] bool canUndo() const { return !m_undo.empty(); }
    /// Sets what was changed last back to what it was before.
    void undo();

Q_SIGNALS:
    /// Anything of the above changed.
    void changed();

private:
    /// One of the things that are decided; its place in the variant says which.
    using Decision = std::variant<LungCondition, VentilatorSettings, Length, BodyPosition>;
    static constexpr std::size_t kThings = std::variant_size_v<Decision>;

    /// What is asked for of one thing.
    struct Wish {
        std::optional<Decision> sent;   ///< proposed, not in force yet
        std::optional<Decision> latest; ///< to be proposed when that is in force
    };
    struct Shown {
        std::array<Decision, kThings> decisions{LungCondition{}, VentilatorSettings{}, Length{},
                                                BodyPosition{}};
        std::array<bool, kThings> pending{};
        QString obstacle;

        friend bool operator==(const Shown&, const Shown&) = default;
    };

    [[nodiscard]] Decision decidedAt(std::size_t thing, SessionTime t) const;
    [[nodiscard]] Decision inForce(std::size_t thing) const;
    [[nodiscard]] std::optional<Decision> pending(std::size_t thing) const;
    [[nodiscard]] Decision shown(std::size_t thing) const;
    [[nodiscard]] bool isUnderWay(const Decision& sent) const;
    void set(const Decision& decision);
    void ask(const Decision& decision);
    void propose(const Decision& decision);
    void refresh();

    SessionModel& m_session;
    StationId m_station;
    std::array<Wish, kThings> m_wishes;
    std::vector<Decision> m_undo; ///< what was before each change
    Shown m_shown;                ///< at the latest signal
};

} // namespace carina
