#pragma once

#include "engine/audio/auscultation.h"
#include "models/patient/patient_model.h"
#include "models/station/station_view.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace carina
{

class SurfaceTree;

/// Where on a patient's chest each sound comes from, in A.
///
/// Lungs and heart: the middle of their surfaces; without a heart, a third of the way from the
/// middle between the lungs to that of the left one. The trachea: a third of the way from glottis
/// to carina. The stomach: beneath the left lung, a tenth of its height below its lowest point.
/// Shares are of ours. A sound is heard in front of where it is: distances are in the plane of x
/// and z.
class ChestSites
{
public:
    explicit ChestSites(const PatientModel& patient);
    ~ChestSites();

    /// What is heard with the stethoscope at a point of A.
    [[nodiscard]] AuscultationGains heardAt(const Vec3& p_AQ) const;

    /// Where breathing is listened for, in the order that is taught: on the skin in front of the
    /// stomach, the left lung and the right one. Without those that the patient does not have.
    [[nodiscard]] std::vector<Vec3> placesToListen() const;

private:
    void place(const PatientModel& patient);
    [[nodiscard]] Vec3 onSkinBefore(const Vec3& p_AS) const;

    std::unique_ptr<const SurfaceTree> m_skin; ///< null without one: no place is off the chest
    std::optional<Vec3> m_right;
    std::optional<Vec3> m_left;
    std::optional<Vec3> m_stomach;
    std::optional<Vec3> m_heart;
    Vec3 m_trachea;
    double m_scale = 1.0;
};

/// A stylus's tip as the bell of a stethoscope: of the styluses that are seen at a station, the one
/// that hears most.
class Stethoscope
{
public:
    /// @returns nothing where no stylus is seen
    [[nodiscard]] std::optional<AuscultationGains> heard(const PatientModel& patient,
                                                         const StationMoment& moment);

private:
    std::string m_patient; ///< content hash of whom the sites are of
    std::unique_ptr<ChestSites> m_sites;
};

} // namespace carina
