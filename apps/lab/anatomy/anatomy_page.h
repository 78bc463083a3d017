#pragma once

#include "apps/lab/command/command.h"

namespace carina::lab
{

// The option of `anatomy` that no other command has, and the keys of what its two ways print.

namespace anatomy_option
{
inline constexpr Option kSet{
    "set", "DIR",
    "folder of the anatomy set with which the patient is compared; none unless given"};
} // namespace anatomy_option

/// Of `anatomy import` and `anatomy list`; all but the last three are written by describeSet().
namespace anatomy_key
{
inline constexpr Key kSchema{"schema", "carina.anatomy/1"};
inline constexpr Key kName{"name", "of the folder"};
inline constexpr Key kContentHash{"content_hash", "SHA-256 over the names and bytes of the files"};
inline constexpr Key kUnit{"unit_mm", "millimetres in one unit of the files"};
inline constexpr Key kAxes{"axes", "where +x, +y and +z of the files point, such as \"left\""};
inline constexpr Key kParts{"parts", "one object per surface:"};
inline constexpr Key kPartName{"name", "in the file", 1};
inline constexpr Key kRole{
    "role", "\"trachea\", \"right_upper_lobe\" ...; \"other\" where it was not recognised", 1};
inline constexpr Key kConceptId{
    "concept_id", "of the Foundational Model of Anatomy; empty where it is not known", 1};
inline constexpr Key kPartTriangles{"triangles", "of the finest level of detail", 1};
inline constexpr Key kLevels{"levels", "how many levels of detail there are", 1};
inline constexpr Key kClosed{"closed", "whether the surface encloses a volume", 1};
inline constexpr Key kVolume{"volume_ml", "that volume; only where the surface is closed", 1};
inline constexpr Key kLungs{"lungs",
                            "volumes, each the sum over the lobes of a lung, or of the whole "
                            "lung:"};
inline constexpr Key kRightLung{"right_ml", "of the right lung; null where the set has none", 1};
inline constexpr Key kLeftLung{"left_ml", "of the left lung; null where the set has none", 1};
inline constexpr Key kTriangles{"triangles", "of all parts at their finest level"};
inline constexpr Key kLandmarks{
    "landmarks_mm", "[x, y, z] of \"incisors\", \"glottis\" and \"carina\" in the anatomy frame "
                    "(origin at the carina, +x left, +y posterior, +z superior); null without a "
                    "trachea"};
inline constexpr Key kAttributions{"attributions",
                                   "lines about licence and copyright, to be shown with the set"};
inline constexpr Key kFaults{"faults", "one object per file that could not be used:"};
inline constexpr Key kFaultyFile{"file", "its name", 1};
inline constexpr Key kFault{"fault", "what is wrong with it", 1};
inline constexpr Key kLeftOut{"left_out",
                              "duplicate surfaces, and whole lungs where lobes are present"};
inline constexpr Key kImportTime{"import_s", "duration of the import, seconds"};
inline constexpr Key kFromCache{"from_cache", "whether the set came from the cache"};
inline constexpr Key kCache{"cache",
                            "the file that keeps the set; null where it could not be written"};
} // namespace anatomy_key

/// Of `anatomy compare`.
namespace anatomy_compare_key
{
inline constexpr Key kSchema{"schema", "carina.anatomy-compare/1"};
inline constexpr Key kPatient{"patient", "WHO as given; \"adult\" where nothing was"};
inline constexpr Key kGenerateTime{"generate_s", "seconds that it took to make the patient"};
inline constexpr Key kTriangles{"triangles", "of all its parts at their finest level"};
inline constexpr Key kLandmarks{
    "landmarks", "places of the made patient from its dimensions, about its carina:"};
inline constexpr Key kIncisors{"incisors_mm", "edge of the upper incisors", 1};
inline constexpr Key kGlottis{"glottis_mm", "middle of the vocal cords", 1};
inline constexpr Key kSternalNotch{"sternal_notch_mm", "upper edge of the manubrium", 1};
inline constexpr Key kXiphoidTip{"xiphoid_tip_mm", "tip of the xiphoid process", 1};
inline constexpr Key kRightRibEnds{"right_rib_ends_mm",
                                   "where each rib becomes cartilage, the first rib first", 1};
inline constexpr Key kLeftRibEnds{"left_rib_ends_mm", "the same of the left side", 1};
inline constexpr Key kIncisorPlane{
    "incisor_plane_normal", "of the plane through the edges of the upper teeth, towards the head",
    1};
inline constexpr Key kTracheaAxis{
    "trachea_axis", "normal of the planes of glottis and carina, towards the head", 1};
inline constexpr Key kSelfIntersections{"self_intersections",
                                        "one object per surface that intersects itself:"};
inline constexpr Key kPart{"part", "its name", 1};
inline constexpr Key kLevel{"level", "of detail", 1};
inline constexpr Key kPairs{"pairs", "of triangles that intersect", 1};
inline constexpr Key kAirwayScale{
    "airway_scale",
    "with --set, as all that follows: factor by which head and airway of the set were scaled"};
inline constexpr Key kChestScale{"chest_scale", "factor by which its chest was scaled"};
inline constexpr Key kFigures{"figures", "one object per measured figure:"};
inline constexpr Key kFigure{"name", "which ends with its unit", 1};
inline constexpr Key kGenerated{"generated", "of the made patient", 1};
inline constexpr Key kReal{"set", "of the scaled set", 1};
inline constexpr Key kDeviation{
    "deviation", "their difference; where \"relative\", as a share of the set's figure", 1};
inline constexpr Key kLimit{"limit", "that the deviation may have", 1};
inline constexpr Key kRelative{"relative", "whether it is a share", 1};
inline constexpr Key kFigureMet{"met", "whether the deviation is within the limit", 1};
inline constexpr Key kOrgans{"organs", "one object per organ that both have:"};
inline constexpr Key kOrgan{"organ", "its name", 1};
inline constexpr Key kToSet{"to_set_mm",
                            "mean distance of the made surface from the surface of the set", 1};
inline constexpr Key kFromSet{"from_set_mm",
                              "mean distance of the surface of the set from the made surface", 1};
inline constexpr Key kMean{"mean_mm", "mean of both; where \"one_way\", the first of them", 1};
inline constexpr Key kOneWay{
    "one_way", "true for bronchi, because those of a set extend beyond those of the patient", 1};
inline constexpr Key kOrganMet{"met", "whether mean_mm is at most 6", 1};
inline constexpr Key kNotInSet{"not_in_set", "organs that only the patient has"};
inline constexpr Key kNotInPatient{"not_in_patient", "organs that only the set has"};
inline constexpr Key kMet{"met", "whether all of this is met"};
inline constexpr Key kUnmet{"unmet", "one line for each demand that is not met"};
} // namespace anatomy_compare_key

} // namespace carina::lab
