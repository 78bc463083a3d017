#pragma once

#include "engine/airway/monitor/patient_ways.h"
#include "engine/airway/scope/flown_scope.h"
#include "models/patient/patient_model.h"

#include <QString>

#include <optional>
#include <string>

namespace carina
{

/// How far the camera of an endoscope has come.
struct EndoscopePlace {
    Length pastTeeth{}; ///< along the airway; below 0 in front of the upper incisors
    bool isAtWall = false;
};

/// An endoscope that a person flies by hand through the airway of a station's patient, for the own
/// eyes alone: it is not shared, moves no tissue and is nothing of the session. It stops at what a
/// laryngoscope's picture shows of the patient, and at the skin; blade, tube and fluids do not stop
/// it.
class FlownEndoscope
{
public:
    /// Of a camera in a man, 4 mm thick as the flexible endoscopes that are used for intubating
    /// adults (3.8 to 4.2 mm); in smaller patients in proportion to the way from the teeth to the
    /// glottis.
    static constexpr Length kRadius = millimetres(2.0);
    /// In front of the upper incisors of a man, where it begins; of ours, in proportion likewise.
    static constexpr Length kInFront = millimetres(30.0);

    /// Whether a patient has lining of throat or larynx, and a trachea, to be flown through.
    [[nodiscard]] static bool hasAirway(const PatientModel& patient);

    FlownEndoscope() = default;
    FlownEndoscope(const FlownEndoscope&) = delete; // walls read what is beside them
    FlownEndoscope& operator=(const FlownEndoscope&) = delete;

    /// Whether the picture is that of this camera.
    [[nodiscard]] bool isFlown() const { return m_isFlown; }
    void fly(bool isFlown) { m_isFlown = isFlown; }

    /// The tissue of this patient lies so from now on. In another patient than before it begins in
    /// front of the mouth. @pre hasAirway(patient)
    void follow(const PatientModel& patient, const AirwayField& changes,
                const FollowingThroat& throat, const BladeField& blade);

    /// As FlownScope; without effect before the first follow().
    void turn(Angle right, Angle up);
    void roll(Angle clockwise);
    void advance(Length way);
    /// In front of the mouth again, looking in.
    void goBack();

    /// X_AD; nothing before the first follow().
    [[nodiscard]] std::optional<RigidTransform> pose() const;
    [[nodiscard]] std::optional<EndoscopePlace> place();
    /// How far before it a picture may begin, so that a wall it touches is seen whole up to the
    /// corners; nothing before the first follow().
    [[nodiscard]] std::optional<Length> nearest() const;

private:
    /// In one patient.
    struct Inside {
        const PatientModel* patient;
        std::string contentHash;
        PatientWays made;    ///< as in the surfaces
        PatientWays ways;    ///< as they are drawn
        AirwayField changes; ///< as the tissue lies, as those that follow; the walls read them
        FollowingThroat throat;
        BladeField blade;
        ScopeWalls walls;
        FlownScope scope;
    };
    void enter(const PatientModel& patient);

    bool m_isFlown = false;
    std::optional<Inside> m_inside;
};

/// "84 mm past the teeth · at the wall".
[[nodiscard]] QString endoscopeText(const EndoscopePlace& place);

} // namespace carina
