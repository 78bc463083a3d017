#pragma once

#include "apps/lab/command/command.h"
#include "apps/lab/command/patient_options.h"
#include "apps/lab/rendering/event_option.h"

#include <array>

namespace carina::lab
{

// Options of `render` for each of its ways, and the keys of what these print.

namespace render_option
{
inline constexpr Option kCheckGeometry{"check-geometry", "", "asks for this check"};
inline constexpr Option kSeed{"seed", "K",
                              "of poses and geometries, 0 to 4294967295; 1 unless given"};
inline constexpr Option kPictures{"pictures", "DIR",
                                  "folder to write into; it is created if missing"};
inline constexpr Option kErrorMap{"error-map", "DIR",
                                  "folder to write into; it is created if missing"};
inline constexpr Option kSize{"size", "WxH", "of each picture, pixels; 1280x800 unless given"};
inline constexpr Option kJawOpening{
    "jaw-deg", "0..30",
    "opens the mouth from being shut, so many degrees about the condyles; where neither this nor "
    "--jaw-forward-mm is given, the mouth is as the surfaces have it, held open in the built-in "
    "patients"};
inline constexpr Option kJawForward{
    "jaw-forward-mm", "0..15",
    "brings the jaw forward from a mouth that is shut, less in proportion in a smaller patient"};
inline constexpr Option kLandmarks{
    "landmarks", "N", "registers on the first N landmarks of tre, 3 to 8; 4 unless given"};
inline constexpr Option kTouchError{
    "fle", "MM", "root mean square error of a touch, 0.01 to 100; 1 unless given"};

inline constexpr Option kLaryngoscopy{"laryngoscopy", "DIR",
                                      "folder to write into; it is created if missing"};
inline constexpr Option kBlade{
    "blade", "NAME",
    "macintosh-0 to -4 (macintosh-3 unless given), miller-0, -1 or -2, or hyperangulated"};
inline constexpr Option kFrom{"from", "EYE",
                              "video: the camera of a video laryngoscope, on the blade (unless "
                              "given); direct: the eye of who looks past the blade"};
inline constexpr Option kLift{"lift-mm", "0..30",
                              "how far the blade is lifted for the last picture; 22 unless given"};
inline constexpr Option kLevering{"levering-deg", "0..30",
                                  "the blade is not lifted, but its handle tipped back so far for "
                                  "the last picture: about its tip to the teeth, then about them"};
inline constexpr Option kCompared{
    "compare", "",
    "also draws each picture in each quality of the programs, and a reference of 16 samples per "
    "pixel in full detail, and prints how alike they are and how fast each is drawn"};
inline constexpr Option kScopeSize{"size", "WxH", "of each picture, pixels; 640x480 unless given"};

inline constexpr Option kPresetGrades{"preset-grades", "", "asks for this count"};
inline constexpr Option kDraws{"draws", "N", "of each preset, 1 to 1000; 20 unless given"};
inline constexpr Option kDrawSeed{"seed", "K", "of the draws, 0 to 4294967295; 1 unless given"};
inline constexpr Option kEventPairs{"event-pairs", "DIR",
                                    "folder to write into; it is created if missing"};
inline constexpr Option kPairEvent{"event", "NAME[=S]",
                                   "only this one, with its severity; may be given once for each "
                                   "that is wanted",
                                   true};
inline constexpr Option kPairSeverity{"severity", "0..1",
                                      "of each event that is given without one; 1, the worst that "
                                      "is drawn, unless given"};

inline constexpr Option kNeckFlexion{"neck-flexion-deg", "-25..35",
                                     "of the neck to the front; 0 unless given"};
inline constexpr Option kHeadExtension{
    "head-extension-deg", "-10..30",
    "of the head against the neck, to the back; 0 unless given. 35 and 24 is the sniffing "
    "position"};

inline constexpr std::array kOfGeometry{kCheckGeometry, kSeed};
inline constexpr std::array kOfPictures{kPictures,   kAnatomy,    kPatient,     kSize,
                                        kCondition,  kSeverity,   kSide,        kVentilator,
                                        kJawOpening, kJawForward, kNeckFlexion, kHeadExtension};
inline constexpr std::array kOfErrorMap{kErrorMap, kAnatomy,   kPatient,
                                        kSize,     kLandmarks, kTouchError};
inline constexpr std::array kOfLaryngoscopy{
    kLaryngoscopy, kAnatomy,       kPatient, kBlade,     kFrom,        kLift,          kLevering,
    kEvent,        kEventSeverity, kPreset,  kScopeSize, kNeckFlexion, kHeadExtension, kCompared};
inline constexpr std::array kOfPresetGrades{kPresetGrades, kDraws, kDrawSeed, kAnatomy,
                                            kPatient,      kBlade, kScopeSize};
inline constexpr std::array kOfEventPairs{kEventPairs, kPairEvent, kPairSeverity, kAnatomy,
                                          kPatient,    kBlade,     kFrom,         kScopeSize};
} // namespace render_option

namespace render_geometry_key
{
inline constexpr Key kSchema{"schema", "carina.render/1"};
inline constexpr Key kPoses{"poses", "of the head that were drawn"};
inline constexpr Key kGeometries{"geometries", "that were drawn for each of them"};
inline constexpr Key kSeed{"seed", "as given"};
inline constexpr Key kMeasured{"spheres_measured", "once for each sphere, pose, geometry and eye"};
inline constexpr Key kLeftOutAtEdge{"left_out_at_edge",
                                    "not measured: outside the picture or cut by its edge"};
inline constexpr Key kLeftOutTouching{"left_out_touching",
                                      "not measured: touching another sphere in the picture"};
inline constexpr Key kNotVisible{"not_visible", "should have been seen, and no pixel shows them"};
inline constexpr Key kSmallestSphere{"smallest_sphere_px",
                                     "pixels of the smallest sphere measured"};
inline constexpr Key kLargestError{"max_projection_error_px",
                                   "largest distance from where a sphere should be seen"};
inline constexpr Key kMeanError{"mean_projection_error_px", "mean of these distances"};
} // namespace render_geometry_key

namespace render_pictures_key
{
inline constexpr Key kSchema{"schema", "carina.render.pictures/1"};
inline constexpr Key kAnatomy{"anatomy", "name of the anatomy that was drawn"};
inline constexpr Key kWidth{"width", "of each picture, pixels"};
inline constexpr Key kHeight{"height", "of each picture, pixels"};
inline constexpr Key kJawOpening{"jaw_deg", "where the jaw was asked for"};
inline constexpr Key kJawForward{"jaw_forward_mm", "where the jaw was asked for"};
inline constexpr Key kNeckFlexion{"neck_flexion_deg", "as drawn"};
inline constexpr Key kHeadExtension{"head_extension_deg", "as drawn"};
inline constexpr Key kPictures{"pictures", "one object per picture:"};
inline constexpr Key kFile{"file", "its name in DIR", 1};
inline constexpr Key kView{"view", "front, side or trainee", 1};
inline constexpr Key kPhase{"phase", "expired or inspired", 1};
inline constexpr Key kCondition{"condition", "its name", 1};
inline constexpr Key kSeverity{"severity", "of the condition", 1};
inline constexpr Key kSide{"side", "both, right or left", 1};
inline constexpr Key kVentilator{"ventilator", "none, volume or pressure", 1};
inline constexpr Key kVolume{"volume_ml", "\"right\" and \"left\": what the vertices drawn enclose",
                             1};
inline constexpr Key kDomeDescent{"dome_descent_mm",
                                  "\"right\" and \"left\": how far the top of the diaphragm is "
                                  "below where it rests in health; 0 for a set without one",
                                  1};
inline constexpr Key kDiaphragmExcursion{
    "diaphragm_excursion_mm",
    "\"right\" and \"left\": how far the diaphragm goes down in "
    "that breath where it does so most; 0 for a set without one",
    1};
} // namespace render_pictures_key

namespace render_error_key
{
inline constexpr Key kSchema{"schema", "carina.render.error/1"};
inline constexpr Key kAnatomy{"anatomy", "name of the anatomy that was drawn"};
inline constexpr Key kLandmarks{"landmarks", "how many"};
inline constexpr Key kTouchError{"fle_mm", "error of a touch"};
inline constexpr Key kLeastError{
    "least_rms_mm", "least root mean square of the expected error on head, airway and lungs"};
inline constexpr Key kMostError{"most_rms_mm", "the greatest of it"};
inline constexpr Key kBand{"band_mm", "from one line to the next"};
inline constexpr Key kPictures{"pictures", "one object per picture:"};
inline constexpr Key kFile{"file", "its name in DIR", 1};
inline constexpr Key kView{"view", "front, side, trainee or cut", 1};
} // namespace render_error_key

namespace render_laryngoscopy_key
{
inline constexpr Key kSchema{"schema", "carina.render.laryngoscopy/1"};
inline constexpr Key kAnatomy{"anatomy", "name of the anatomy that was drawn"};
inline constexpr Key kWidth{"width", "of each picture, pixels"};
inline constexpr Key kHeight{"height", "of each picture, pixels"};
inline constexpr Key kBlade{"blade", "its name"};
inline constexpr Key kFrom{"from", "video or direct"};
inline constexpr Key kNeckFlexion{"neck_flexion_deg", "as drawn"};
inline constexpr Key kHeadExtension{"head_extension_deg", "as drawn"};
inline constexpr Key kMouthToSight{
    "mouth_to_sight_deg",
    "between the axis of the mouth, along the hard palate, and the line from incisors to glottis"};
inline constexpr Key kSightToLarynx{"sight_to_larynx_deg",
                                    "between that line and the axis of the larynx"};
inline constexpr Key kTeethToCarina{"teeth_to_carina_mm", "along the way of a tube"};
inline constexpr Key kEvents{"events", "one object per event that was asked for:"};
inline constexpr Key kEventName{"event", "its name", 1};
inline constexpr Key kSeverity{"severity", "0 to 1", 1};
inline constexpr Key kRates{
    "frames_per_s",
    "\"quick\", \"smoothed\" and \"fine\": how often the last picture is drawn in a second in "
    "each quality, without a pause between frames; only with --compare"};
inline constexpr Key kPictures{"pictures", "one object per picture:"};
inline constexpr Key kFile{"file", "its name in DIR", 1};
inline constexpr Key kStep{"step", "teeth, uvula, epiglottis, partial_view or full_view", 1};
inline constexpr Key kLift{"lift_mm", "of the blade", 1};
inline constexpr Key kOpening{"pogo_percent",
                              "percentage of glottic opening: the share that is seen of the line "
                              "from the anterior commissure "
                              "to the interarytenoid notch",
                              1};
inline constexpr Key kGrade{"cormack_lehane", "grade: 1, 2a, 2b, 3 or 4", 1};
inline constexpr Key kTongueForce{"tongue_force_N", "estimate (docs/laryngoscopy.md)", 1};
inline constexpr Key kEpiglottisForce{"epiglottis_force_N", "estimate; of a straight blade", 1};
inline constexpr Key kIncisorForce{"incisor_force_N", "estimate; on the upper incisors", 1};
inline constexpr Key kIncisorClearance{"incisor_clearance_mm",
                                       "from the blade to the edge of the upper incisors, less "
                                       "than 0 inside it; null where no part of the blade is there",
                                       1};
inline constexpr Key kLeveringShare{"levering_percent",
                                    "of the way of the tip since the blade lay on the teeth, what "
                                    "turning about them has done",
                                    1};
inline constexpr Key kHandling{"handling", "neither, lifting or levering", 1};
inline constexpr Key kReference{"reference_file", "its name in DIR; only with --compare", 1};
inline constexpr Key kSimilarity{
    "ssim",
    "\"quick\", \"smoothed\" and \"fine\": structural similarity of the luma in each quality "
    "to the reference, windows of 11x11 pixels (Wang et al. 2004); only with --compare",
    1};
inline constexpr Key kPixels{
    "visible_pixels",
    "of each structure that is seen: teeth, jaw, tongue, hard_palate, soft_palate, pharynx, "
    "epiglottis, aryepiglottic_folds, vestibular_folds, arytenoids, vocal_folds, "
    "laryngeal_cartilages, trachea, oesophagus, blade, tube, fluid, foreign_body, and nothing "
    "where there is none",
    1};
} // namespace render_laryngoscopy_key

namespace render_grades_key
{
inline constexpr Key kSchema{"schema", "carina.render.grades/1"};
inline constexpr Key kAnatomy{"anatomy", "name of the anatomy that was drawn"};
inline constexpr Key kBlade{"blade", "its name"};
inline constexpr Key kWidth{"width", "of each picture, pixels"};
inline constexpr Key kHeight{"height", "of each picture, pixels"};
inline constexpr Key kLift{"lift_mm", "of the blade"};
inline constexpr Key kSeed{"seed", "as given"};
inline constexpr Key kPresets{"presets", "one object per preset that is named for a grade:"};
inline constexpr Key kPreset{"preset", "its name", 1};
inline constexpr Key kNamedGrade{"named_grade", "1 to 4, of which 2 is 2a and 2b", 1};
inline constexpr Key kFrom{"from", "by which eye it has that grade: video or direct", 1};
inline constexpr Key kNeckFlexion{"neck_flexion_deg", "in which it has it", 1};
inline constexpr Key kHeadExtension{"head_extension_deg",
                                    "likewise; a stiff neck keeps the head back from both", 1};
inline constexpr Key kDraws{"draws", "how many", 1};
inline constexpr Key kGrades{"grades", "how many of them were of each grade: 1, 2a, 2b, 3, 4", 1};
inline constexpr Key kShareRight{"share_right", "of the draws, that are of the named grade", 1};
inline constexpr Key kRanges{"ranges", "what was drawn from, one object per event:", 1};
inline constexpr Key kEvent{"event", "its name", 2};
inline constexpr Key kLeast{"least", "its lowest severity", 2};
inline constexpr Key kMost{"most", "its highest severity", 2};
inline constexpr Key kSource{"source", "why the event belongs there; the severities are of ours",
                             2};
} // namespace render_grades_key

namespace render_pairs_key
{
inline constexpr Key kSchema{"schema", "carina.render.pairs/1"};
inline constexpr Key kAnatomy{"anatomy", "name of the anatomy that was drawn"};
inline constexpr Key kBlade{"blade", "its name"};
inline constexpr Key kFrom{"from", "video or direct"};
inline constexpr Key kWidth{"width", "of each picture, pixels"};
inline constexpr Key kHeight{"height", "of each picture, pixels"};
inline constexpr Key kLeftOut{"left_out", "names of events that this patient cannot show"};
inline constexpr Key kPairs{"pairs", "one object per event:"};
inline constexpr Key kEvent{"event", "its name", 1};
inline constexpr Key kSeverity{"severity", "0 to 1", 1};
inline constexpr Key kStep{"step",
                           "of the laryngoscopy, that in which most of the picture changes: teeth, "
                           "uvula, epiglottis, partial_view or full_view",
                           1};
inline constexpr Key kChanged{"changed_percent", "of the picture: pixels of another colour", 1};
inline constexpr Key kPixelsMore{
    "pixels_more", "of each structure of which more (or less, if below 0) is seen", 1};
inline constexpr Key kBefore{"before", "the picture without the event:", 1};
inline constexpr Key kAfter{"after", "the picture with it, an object with the same keys", 1};
inline constexpr Key kFile{"file", "its name in DIR", 2};
inline constexpr Key kOpening{"pogo_percent", "percentage of glottic opening", 2};
inline constexpr Key kGrade{"cormack_lehane", "grade: 1, 2a, 2b, 3 or 4", 2};
inline constexpr Key kNeckFlexion{"neck_flexion_deg", "as drawn", 2};
inline constexpr Key kHeadExtension{"head_extension_deg", "as drawn", 2};
inline constexpr Key kTeeth{"upper_teeth",
                            "firm, loose or loose_and_near: as the programs call them, beneath the "
                            "picture",
                            2};
inline constexpr Key kPixels{"visible_pixels", "of each structure that is seen", 2};
} // namespace render_pairs_key

} // namespace carina::lab
