#include "models/vitals/stethoscope.h"

#include "engine/geometry/mesh/surface_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carina
{
namespace
{

constexpr double kGrownLungs_m = 0.16; ///< between the middles of a grown person's lungs
constexpr double kToLeft = 1.0 / 3.0;
constexpr double kBelowGlottis = 1.0 / 3.0;
constexpr double kBelowLung = 0.1;
constexpr double kInTheAir_m = 1.0;  ///< in front of any chest
constexpr double kOnSkin_m = 0.0005; ///< a bell that is as near touches it

/// A surface of this role; null without one.
const TriangleMesh* surfaceOf(const PatientModel& patient, PartRole role)
{
    for (const PatientSurface& surface : patient.surfaces())
        if (surface.description.role == role)
            return surface.levels.back().get(); // coarse enough to be searched at once
    return nullptr;
}

Box lungBox(const PatientModel& patient, Side side)
{
    Box box;
    for (const PatientSurface& surface : patient.surfaces())
        if (lungSide(surface.description.role) == side)
            box.include(boundsOf(*surface.levels.front()));
    return box;
}

/// In front of it; infinite for what a patient does not have.
Length distanceInFront(const std::optional<Vec3>& p_AS, const Vec3& p_AQ)
{
    if (!p_AS)
        return metres(std::numeric_limits<double>::infinity());
    return metres(std::hypot(p_AS->x() - p_AQ.x(), p_AS->z() - p_AQ.z()));
}

double loudest(const AuscultationGains& gains)
{
    return std::max({gains.right, gains.left, gains.stomach, gains.heart, gains.trachea});
}

} // namespace

ChestSites::ChestSites(const PatientModel& patient)
    : m_trachea{(1.0 - kBelowGlottis) * patient.landmarks().p_A_glottis
                + kBelowGlottis * patient.landmarks().p_A_carina}
{
    if (const TriangleMesh* skin = surfaceOf(patient, PartRole::Skin))
        m_skin = std::make_unique<SurfaceTree>(*skin);
    place(patient);
}

ChestSites::~ChestSites() = default;

void ChestSites::place(const PatientModel& patient)
{
    const Box right = lungBox(patient, Side::Right);
    const Box left = lungBox(patient, Side::Left);
    if (!right.empty())
        m_right = right.centre();
    if (!left.empty()) {
        m_left = left.centre();
        m_stomach =
            Vec3{left.centre().x(), left.centre().y(), left.min.z() - kBelowLung * left.size().z()};
    }
    if (m_right && m_left) {
        m_scale = (*m_left - *m_right).norm() / kGrownLungs_m;
        m_heart = (1.0 - kToLeft) * 0.5 * (*m_right + *m_left) + kToLeft * *m_left;
    }
    if (const TriangleMesh* heart = surfaceOf(patient, PartRole::Heart))
        m_heart = boundsOf(*heart).centre();
}

AuscultationGains ChestSites::heardAt(const Vec3& p_AQ) const
{
    const Length skin = metres(m_skin ? m_skin->distanceTo(p_AQ) : 0.0);
    return auscultate({distanceInFront(m_right, p_AQ), distanceInFront(m_left, p_AQ),
                       distanceInFront(m_stomach, p_AQ), distanceInFront(m_heart, p_AQ),
                       distanceInFront(m_trachea, p_AQ), skin},
                      m_scale);
}

std::vector<Vec3> ChestSites::placesToListen() const
{
    std::vector<Vec3> places;
    for (const std::optional<Vec3>& p_AS : {m_stomach, m_left, m_right})
        if (p_AS)
            places.push_back(onSkinBefore(*p_AS));
    return places;
}

/// From the air straight to a site, each time by as much as the skin is away at least.
Vec3 ChestSites::onSkinBefore(const Vec3& p_AS) const
{
    if (!m_skin)
        return p_AS;
    Vec3 p_AQ = p_AS - kInTheAir_m * Vec3::UnitY();
    for (double away = m_skin->distanceTo(p_AQ); away > kOnSkin_m && p_AQ.y() < p_AS.y();
         away = m_skin->distanceTo(p_AQ))
        p_AQ.y() += away;
    return p_AQ;
}

std::optional<AuscultationGains> Stethoscope::heard(const PatientModel& patient,
                                                    const StationMoment& moment)
{
    std::optional<AuscultationGains> heard;
    for (const PersonPose& person : moment.people) {
        if (person.kind != ObjectKind::Stylus || person.pose.validity == Validity::Lost)
            continue;
        if (!m_sites || m_patient != patient.contentHash()) {
            m_sites = std::make_unique<ChestSites>(patient);
            m_patient = patient.contentHash();
        }
        const AuscultationGains there = m_sites->heardAt(person.pose.X_FO.translation());
        if (!heard || loudest(there) > loudest(*heard))
            heard = there;
    }
    return heard;
}

} // namespace carina
