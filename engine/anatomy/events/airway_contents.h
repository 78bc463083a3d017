#pragma once

#include "engine/anatomy/events/airway_event.h"
#include "engine/anatomy/laryngoscopy/upper_airway.h"
#include "engine/geometry/mesh/triangle_mesh.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace carina
{

/// The events by which something lies in the throat: three fluids, and a solid.
inline constexpr std::array kThroatFluids{AirwayEventKind::Secretions, AirwayEventKind::Blood,
                                          AirwayEventKind::Vomit};
inline constexpr std::array kThroatContents{AirwayEventKind::Secretions, AirwayEventKind::Blood,
                                            AirwayEventKind::Vomit, AirwayEventKind::ForeignBody};

/// Where something lies there.
enum class ContentPlace : std::uint8_t { Throat, Vallecula };

/// Something that lies there, in a frame F with the axes of A: its place p_F is at
/// p_AF + size * p_F.
struct ThroatContent {
    AirwayEventKind kind = AirwayEventKind::Secretions;
    Vec3 p_AF = Vec3::Zero();
    double size = 1.0; ///< of a man's
    ContentPlace place = ContentPlace::Throat;
    Length depth{}; ///< of a fluid in the throat, in F: to the wall behind the notch
};

/// The fluids, each with its own level. A patient lies supine, so that a fluid stands behind the
/// larynx and in the piriform fossae first, whatever head and neck do, and its surface is the plane
/// y = 0 of F. In a man it is kDeepestFluid times the severity before the back wall, which is taken
/// to be kBackWall behind the interarytenoid notch: at 0.4 it reaches the notch, at 1 it covers
/// half of the glottis. Levels go with the size of the larynx, the surface's breadth with that of
/// the airway. All lengths are of ours.
/// @param airway as head and neck lie, but neither changed by events nor lifted
[[nodiscard]] std::vector<ThroatContent> fluidsIn(const UpperAirway& airway,
                                                  const AirwayEvents& events);
inline constexpr Length kBackWall = millimetres(7.5);
inline constexpr Length kDeepestFluid = millimetres(20.0);

/// What of the same fluids stands in the vallecula of who lies on the back: a little, on the front
/// of the epiglottis, between it and the tongue, from which a thick fluid does not run off at once.
/// Its size goes with the severity, and it is to be moved as the larynx is. All of that is of ours.
/// @param airway as in the surfaces
[[nodiscard]] std::vector<ThroatContent> valleculaFluidsIn(const UpperAirway& airway,
                                                           const AirwayEvents& events);

/// A solid: at a severity near 0 in the right piriform fossa, at 1 over the middle of the glottis,
/// evenly between. It is to be moved as the larynx is. Both places and its size go with the size of
/// the larynx, and are of ours.
/// @param airway as in the surfaces
[[nodiscard]] std::optional<ThroatContent> foreignBodyIn(const UpperAirway& airway,
                                                         const AirwayEvents& events);
inline constexpr Length kForeignBody = millimetres(15.0); ///< its length in a man

/// A fluid in a man, in F, closed: its surface from kFluidFoot below the origin, which is the notch
/// but for the level, up into the nasopharynx, as wide as the pharynx is there (pharynxSectionAt),
/// and kFluidBehind from there to the back. What of it would be outside the pharynx is hidden by
/// the walls of that, and its upper end by the palate; an eye in the midst of it sees nothing else.
/// The surface is flat, with the normals of long waves.
[[nodiscard]] TriangleMesh fluidMesh();
inline constexpr Length kFluidFoot = millimetres(8.0);
inline constexpr Length kFluidBehind = millimetres(30.0);

/// A fluid for who sees it from outside, in F likewise: the same surface, but no farther up than
/// the palate, and only as far, and only as deep, as it stands before the back wall
/// (pharynxSectionAt), which comes forward towards the palate. Across, its bottom is half an
/// ellipse.
/// @param depth of ThroatContent, above 0
[[nodiscard]] TriangleMesh poolMesh(Length depth);

/// A fluid in the vallecula of a man at severity 1, in F: its surface is an ellipse in the plane
/// y = 0, and half an ellipsoid lies behind.
[[nodiscard]] TriangleMesh valleculaPoolMesh();
inline constexpr Length kValleculaPoolWidth = millimetres(16.0);
inline constexpr Length kValleculaPoolHeight = millimetres(9.0);
inline constexpr Length kValleculaPoolDepth = millimetres(3.0);

} // namespace carina
