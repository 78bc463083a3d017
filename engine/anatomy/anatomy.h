#pragma once

#include "engine/geometry/mesh/triangle_mesh.h"
#include "engine/geometry/mesh/vertex_color.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace carina
{

/// The kind of a part, as far as Carina treats parts differently.
enum class PartRole : std::uint8_t {
    Trachea,
    RightMainBronchus,
    LeftMainBronchus,
    BronchialTree,
    Larynx,
    Epiglottis,
    RightUpperLobe,
    RightMiddleLobe,
    RightLowerLobe,
    LeftUpperLobe,
    LeftLowerLobe,
    RightLung, ///< the whole lung, where there are no lobes
    LeftLung,
    Diaphragm,
    Mandible,
    Tooth,
    Tongue,
    Pharynx,
    Oesophagus,
    Skull,
    Spine,
    Rib, ///< ribs, cartilages, sternum, clavicles, scapulae
    Heart,
    Vessel,
    Muscle,
    Skin,
    Mucosa,          ///< what lines mouth and pharynx, with lips and gums
    LaryngealMucosa, ///< what lines the larynx, with its other folds
    VocalFold,       ///< white where the mucosa is pink
    Hyoid,           ///< the hyoid bone, in the root of the tongue
    Other,
};

enum class Side : std::uint8_t { Right, Left };

/// The side of a lobe or whole lung; nothing for other roles.
[[nodiscard]] std::optional<Side> lungSide(PartRole role);

/// The name of a role in files and JSON ("right_upper_lobe"), which does not change, and its
/// inverse; nothing for an unknown name.
[[nodiscard]] const char* roleName(PartRole role);
[[nodiscard]] std::optional<PartRole> roleFromName(const std::string& name);

/// One surface of a patient, in frame A, in one or more levels of detail.
struct AnatomyPart {
    std::string name; ///< as shown: "Trachea", "Left second rib"
    PartRole role = PartRole::Other;
    std::string conceptId;            ///< FMA id such as "FMA7394"; empty where unknown
    std::vector<TriangleMesh> levels; ///< at least one; finest first, normals present in each
    /// Deviation of each level from the finest, metres; one per level, or empty where unknown.
    std::vector<double> deviations{};
    /// Colours from the surface's file, one per vertex of each level; empty where it is drawn in
    /// the colour of its role.
    std::vector<std::vector<Rgb>> colors{};
};

/// The landmarks of a patient's airway and the path of a tube, in A, metres.
struct AirwayLandmarks {
    Vec3 p_A_incisors = Vec3::Zero(); ///< midpoint of the upper incisors' edge
    Vec3 p_A_glottis = Vec3::Zero();  ///< midpoint between the vocal cords
    Vec3 p_A_carina = Vec3::Zero();   ///< the ridge where the trachea divides: the origin of A
    std::vector<Vec3> path_A;         ///< centreline from in front of the incisors to the carina
};

/// A virtual patient: parts in frame A (origin at the carina, +x patient's left, +y posterior, +z
/// superior, metres).
struct Anatomy {
    std::string name; ///< "Adult", "12 years, 150 cm, boy", or the folder's name
    /// Identifies the patient: SHA-256 in hex of the files of a set; for a built-in patient its
    /// name and the version of its formulas, such as "builtin-adult-2".
    std::string contentHash;
    std::vector<AnatomyPart> parts;
    AirwayLandmarks landmarks;
    std::vector<std::string> attributions; ///< licence lines to show
};

} // namespace carina
