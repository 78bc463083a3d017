#include "models/station/flown_endoscope.h"

#include "engine/airway/monitor/drawn_ways.h"
#include "engine/anatomy/laryngoscopy/seen_structure.h"
#include "models/intubation/ways_in_patient.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace carina
{
namespace
{

constexpr Length kReach = millimetres(50.0);  ///< walls beside the ways of a man: of ours
constexpr Length kSpacing = millimetres(8.0); ///< of the places from which that is taken

/// Of an open mouth in a man, of ours: its middle below the upper incisors' edge, and how far from
/// there skin lies over it.
constexpr Length kToMouth = millimetres(10.0);
constexpr Length kMouthRadius = millimetres(16.0);
constexpr Length kLipsReach = millimetres(40.0);

class EndoscopeWords
{
    Q_DECLARE_TR_FUNCTIONS(Endoscope)

public:
    static QString of(const EndoscopePlace& place)
    {
        const long mm = std::lround(inMillimetres(place.pastTeeth));
        const QString where = mm < 0 ? tr("Camera %1 mm in front of the teeth").arg(-mm)
                                     : tr("Camera %1 mm past the teeth").arg(mm);
        return place.isAtWall ? tr("%1 · at the wall", "depth of a camera").arg(where) : where;
    }
};

bool isLining(PartRole role)
{
    return role == PartRole::Mucosa || role == PartRole::Pharynx || role == PartRole::Larynx
           || role == PartRole::LaryngealMucosa;
}

bool stopsCamera(const PatientSurface& surface)
{
    return surface.body != SurfaceBody::Tube
           && (surface.description.role == PartRole::Skin
               || structureOf(surface.description) != SeenStructure::Nothing);
}

/// A surface without what lies so near a line.
TriangleMesh opened(const TriangleMesh& mesh, std::span<const Vec3> line, Length radius)
{
    TriangleMesh open = mesh;
    std::erase_if(open.triangles, [&](const Triangle& t) {
        return std::ranges::any_of(t, [&](std::uint32_t corner) {
            const Vec3 p_A = mesh.positions[corner].cast<double>();
            const PlaceOnWay place = nearestOnWay(line, p_A);
            return place.along <= lengthOf(line) && place.off < radius;
        });
    });
    return open;
}

/// Before the mouth and in it.
Centreline mouthLine(const PatientWays& ways)
{
    const Vec3 p_A = ways.p_A_incisors() - ways.size * kToMouth.si * Vec3::UnitZ();
    const Vec3 way = ways.size * kLipsReach.si * ways.inward_A();
    return {p_A - way, p_A + way};
}

/// Skin lies over mouths that are open: it is taken without what is there.
std::vector<AnatomyPart> wallsOf(const PatientModel& patient, const PatientWays& ways)
{
    const Centreline mouth = mouthLine(ways);
    std::vector<AnatomyPart> parts;
    for (const PatientSurface& surface : patient.surfaces()) {
        if (!stopsCamera(surface))
            continue;
        const TriangleMesh& mesh = *surface.levels.front();
        const bool isSkin = surface.description.role == PartRole::Skin;
        parts.push_back(surface.description);
        parts.back().levels.push_back(isSkin ? opened(mesh, mouth, ways.size * kMouthRadius)
                                             : mesh);
    }
    return parts;
}

/// All ways, and what is in front of the teeth.
Centreline flownLine(const PatientWays& ways)
{
    Centreline line{ways.p_A_incisors()
                    - ways.size * FlownEndoscope::kInFront.si * ways.inward_A()};
    for (const Centreline* way : {&ways.overTongue, &ways.trachea, &ways.oesophagus}) {
        const Centreline coarse = evenlySpaced(*way, kSpacing);
        line.insert(line.end(), coarse.begin(), coarse.end());
    }
    line.push_back(ways.p_A_rightEnd);
    line.push_back(ways.p_A_leftEnd);
    return line;
}

/// Looking in, with the patient's feet up in the picture, so that the larynx has its front there,
/// as for who stands at the head.
RigidTransform inFrontOfMouth(const PatientWays& ways)
{
    const Vec3 ahead = ways.inward_A();
    const Vec3 right = ahead.cross(Vec3{-Vec3::UnitZ()}).normalized();
    Mat3 R_AD;
    R_AD << right, right.cross(ahead), -ahead;
    return {Quat{R_AD}, ways.p_A_incisors() - ways.size * FlownEndoscope::kInFront.si * ahead};
}

Length pastTeeth(const PatientWays& ways, const Vec3& p_A)
{
    const double inward = (p_A - ways.p_A_incisors()).dot(ways.inward_A());
    const PlaceOnWay inMouth = nearestOnWay(ways.overTongue, p_A);
    if (inward < 0.0 && inMouth.along.si <= 0.0)
        return metres(inward);
    const Length toGlottis = lengthOf(ways.overTongue);
    const Length toCarina = toGlottis + lengthOf(ways.trachea);
    Length depth = inMouth.along;
    Length least = inMouth.off;
    const auto look = [&](std::span<const Vec3> line, Length before) {
        if (const PlaceOnWay place = nearestOnWay(line, p_A); place.off < least) {
            least = place.off;
            depth = before + place.along;
        }
    };
    look(ways.trachea, toGlottis);
    look(ways.oesophagus, toGlottis);
    look(std::array{ways.p_A_carina(), ways.p_A_rightEnd}, toCarina);
    look(std::array{ways.p_A_carina(), ways.p_A_leftEnd}, toCarina);
    return depth;
}

} // namespace

bool FlownEndoscope::hasAirway(const PatientModel& patient)
{
    const auto has = [&](const auto& isOne) {
        return std::ranges::any_of(patient.surfaces(), [&](const PatientSurface& surface) {
            return isOne(surface.description.role);
        });
    };
    return has(isLining) && has([](PartRole role) { return role == PartRole::Trachea; });
}

void FlownEndoscope::enter(const PatientModel& patient)
{
    PatientWays ways = waysOf(patient);
    const double size = std::min(ways.size, 1.0);
    ScopeWalls walls{wallsOf(patient, ways), flownLine(ways), ways.size * kReach};
    m_inside.emplace(Inside{.patient = &patient,
                            .contentHash = patient.contentHash(),
                            .made = ways,
                            .ways = ways,
                            .changes = {},
                            .throat = {},
                            .blade = {},
                            .walls = std::move(walls),
                            .scope = FlownScope{size * kRadius}});
}

void FlownEndoscope::follow(const PatientModel& patient, const AirwayField& changes,
                            const FollowingThroat& throat, const BladeField& blade)
{
    const bool isNew = !m_inside || m_inside->patient != &patient
                       || m_inside->contentHash != patient.contentHash();
    if (isNew)
        enter(patient);
    m_inside->changes = changes;
    m_inside->throat = throat;
    m_inside->blade = blade;
    m_inside->ways = drawnWays(m_inside->made, changes, throat, blade);
    const TissueMotion motion = tissueMotion(m_inside->changes, m_inside->throat);
    const TissueMotion push = bladePushing(m_inside->blade);
    m_inside->walls.move([motion, push](const Vec3& p_A, AirwayTissue tissue) -> Vec3 {
        const Vec3 moved = motion(p_A, tissue);
        return push ? push(moved, tissue) : moved;
    });
    if (isNew)
        goBack();
    else
        m_inside->scope.follow(m_inside->walls);
}

void FlownEndoscope::turn(Angle right, Angle up)
{
    if (m_inside)
        m_inside->scope.turn(right, up);
}

void FlownEndoscope::roll(Angle clockwise)
{
    if (m_inside)
        m_inside->scope.roll(clockwise);
}

void FlownEndoscope::advance(Length way)
{
    if (m_inside)
        m_inside->scope.advance(way, m_inside->walls);
}

void FlownEndoscope::goBack()
{
    if (m_inside)
        m_inside->scope.place(inFrontOfMouth(m_inside->ways));
}

std::optional<RigidTransform> FlownEndoscope::pose() const
{
    return m_inside ? std::optional{m_inside->scope.pose()} : std::nullopt;
}

std::optional<EndoscopePlace> FlownEndoscope::place()
{
    if (!m_inside)
        return std::nullopt;
    return EndoscopePlace{.pastTeeth =
                              pastTeeth(m_inside->ways, m_inside->scope.pose().translation()),
                          .isAtWall = m_inside->scope.isAtWall(m_inside->walls)};
}

std::optional<Length> FlownEndoscope::nearest() const
{
    constexpr double kOfRadius = 0.5; // a corner of the picture is 1.31 times as far away
    return m_inside ? std::optional{kOfRadius * m_inside->scope.radius()} : std::nullopt;
}

QString endoscopeText(const EndoscopePlace& place) { return EndoscopeWords::of(place); }

} // namespace carina
