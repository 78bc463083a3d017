#pragma once

#include "apps/lab/command/command.h"

namespace carina::lab
{

// The options of `anatomy` that no other command has, and the keys of what its ways print.

namespace anatomy_option
{
inline constexpr Option kSet{
    "set", "DIR",
    "folder of the anatomy set with which the patient is compared; none unless given"};
inline constexpr Option kSeeds{
    "seeds", "N",
    "how many combinations are drawn at random, by the seeds 1 to N; 100 unless given"};
inline constexpr Option kLevel{
    "level", "L",
    "of detail, 0 being the finest, or the coarsest of a part that does not have it; the coarsest "
    "of each part unless given"};
inline constexpr Option kWithoutLimits{"without-limits", "",
                                       "leaves out the combinations at the limits"};
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
inline constexpr Key kLimit{"limit", "that the deviation may have; null where it may have any", 1};
inline constexpr Key kRelative{"relative", "whether it is a share", 1};
inline constexpr Key kFigureMet{"met", "whether the deviation is within the limit, if there is one",
                                1};
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

/// Of `anatomy sweep`.
namespace anatomy_sweep_key
{
inline constexpr Key kSchema{"schema", "carina.anatomy-sweep/1"};
inline constexpr Key kPatient{"patient", "WHO as given; \"adult\" where nothing was"};
inline constexpr Key kLevel{"level", "L; null for the coarsest of each part"};
inline constexpr Key kSeeds{"seeds", "N"};
inline constexpr Key kCombinations{"combinations", "how many there were"};
inline constexpr Key kSelfIntersecting{
    "self_intersecting", "of these, in how many at least one surface intersects itself"};
inline constexpr Key kFolded{
    "folded", "and in how many the determinant of a deformation gradient is not above 0"};
inline constexpr Key kLeast{"least_determinant", "the smallest at the vertices of any part:"};
inline constexpr Key kDeterminant{"determinant", "its value", 1};
inline constexpr Key kPart{"part", "name of the part", 1};
inline constexpr Key kPlace{"p_mm", "[x, y, z] of the vertex in the surfaces", 1};
inline constexpr Key kParameters{"parameters", "of the combination:", 1};
inline constexpr Key kSeed{"seed", "by which it was drawn; null at a limit", 2};
inline constexpr Key kNeckFlexion{"neck_flexion_deg", "of the neck on the trunk", 2};
inline constexpr Key kHeadExtension{"head_extension_deg", "of the head against the neck", 2};
inline constexpr Key kJawOpening{
    "jaw_opening_deg",
    "from the closed mouth; null as in the surfaces, and with a blade, with which the jaw moves",
    2};
inline constexpr Key kJawForward{"jaw_forward_mm", "likewise", 2};
inline constexpr Key kBlade{"blade", "its name; null without one, as the three that follow", 2};
inline constexpr Key kProgress{
    "progress", "of the laryngoscopy: 0 at the teeth, 1 uvula, 2 epiglottis, 3 and 4 lifted", 2};
inline constexpr Key kLift{"lift_mm", "of the whole lift", 2};
inline constexpr Key kLevering{"levering_deg", "by which the handle is tipped back", 2};
inline constexpr Key kEvents{"events", "by name, how severe each is, 0 to 1", 2};
inline constexpr Key kParts{"parts", "one object per part that is deformed:"};
inline constexpr Key kInCombinations{"self_intersecting",
                                     "in how many combinations it intersects itself", 1};
inline constexpr Key kPartsLeast{"least_determinant", "the smallest of it", 1};
inline constexpr Key kBad{"bad", "one object per part and combination with a fault: \"part\", "
                                 "\"determinant\" and \"parameters\" as above, and"};
inline constexpr Key kPairs{"pairs", "of triangles that intersect", 1};
inline constexpr Key kSweepTime{"sweep_s", "seconds that all took, without making the patient"};
} // namespace anatomy_sweep_key

/// Of `anatomy dimensions`.
namespace anatomy_dimensions_key
{
inline constexpr Key kSchema{"schema", "carina.anatomy-dimensions/1"};
inline constexpr Key kPatients{"patients", "one object per patient:"};
inline constexpr Key kPatient{"patient", "who it is, as --patient takes it", 1};
inline constexpr Key kAge{"age_years", "of that person: 1.5 at 18 months", 1};
inline constexpr Key kSex{"sex", "\"male\" or \"female\"", 1};
inline constexpr Key kMeasured{"measured", "by name, each dimension measured on the surfaces", 1};
inline constexpr Key kDimensions{
    "dimensions", "one object per published figure of a dimension, for this age and sex:", 1};
inline constexpr Key kName{"name", "of the dimension, which ends with its unit", 2};
inline constexpr Key kValue{"measured", "on the surfaces", 2};
inline constexpr Key kPublished{"published", "mean in people, of this height and age", 2};
inline constexpr Key kDeviation{"sd", "standard deviation of it; null where none was found", 2};
inline constexpr Key kZ{"z", "(measured - published) / sd; null without one", 2};
inline constexpr Key kSource{"source", "of whom it is, and who published it", 2};
inline constexpr Key kWithin{
    "within", "how many dimensions are within one standard deviation of at least one source", 1};
inline constexpr Key kBeyond{"beyond", "names of those that are within that of none", 1};
} // namespace anatomy_dimensions_key

} // namespace carina::lab
