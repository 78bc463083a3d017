#pragma once

#include "engine/core/result.h"
#include "engine/io/site/site.h"

#include <filesystem>

namespace carina
{

/// Reads a site file: a JSON object with lengths in millimetres, angles in degrees, poses as four
/// rows of four numbers and times as in ISO 8601. Unknown values are left out.
///
///     schema        "carina.site/6"
///     step          "overview", "tracker", "stylus", "landmarks", "touch", "fit", "verify" or
///                   "tools"
///     operator      text
///     tracker       text
///     devices       a list of file, which describes a device (readAnyDescription), beside this one
///                   or below, and of all but the first frame: X_TD_mm, late_ms, rms_mm, rms_deg,
///                   pairs and calibrated_at
///     styluses      a list of tool, p_SQ_mm, rms_mm, calibrated_at, covariance_S_mm2 (xx, xy, xz,
///                   yy, yz, zz), poses, outliers, axis: axis_S, wobble_deg, calibrated_at
///     tools         a list of tubes and laryngoscopes: see tool_json.h
///     patient       text: its display name; the catalogue's anatomy identifies it
///     catalogue     name, anatomy, landmarks: a list of name and p_AQ_mm
///     touched       a list of landmark, p_TQ_mm, spread_mm, q_TS (x, y, z, w), stale,
///                   seen_error_mm (RMS, with which the tracker saw the tip meanwhile) or left out,
///                   and fitted: true or left out
///     registration  X_AM_mm, X_AT_mm, X_JM_mm, X_BM_mm, rms_mm, residuals_mm: a list of name, mm
///                   and left_out_mm; covariance_mm_mrad: the upper triangle, row by row, turns in
///                   milliradians before shifts in millimetres; fle_mm, degrees_of_freedom,
///                   pooled, disagreeing, made_at, operator, swab: surface, points, outliers,
///                   start_rms_mm, rms_mm, moved_mm; relays: a list of at, operator, landmarks and
///                   rms_mm; stale
///     localisations a list of rms_mm, degrees_of_freedom, at and operator
///     relay         as touched: while the manikin is registered again
///     verification  verdict ("open", "good", "not good"), at, operator, points: a list of name,
///                   p_AQ_mm, p_TQ_mm, error_mm and bound_mm; stale
///     display       p_HDl_mm, p_HDr_mm, p_HQ_screen_centre_mm, screen_width_mm, screen_height_mm
///     manikin       see manikin_json.h
///     digest        of all other fields (checkDigest of them as JSON without blanks, in the order
///                   of their names), 40 hexadecimal digits
///
/// stale is the input changed after the result: "tracker", also for the frame of one of its
/// devices, "stylus", "landmarks", "manikin", "touches" or "fit". The earlier versions are read
/// too: "carina.site/5" without devices, "carina.site/4" without tools, "carina.site/3" without a
/// digest, which is what a person writes by hand, "carina.site/2" without manikin and
/// localisations, and "carina.site/1" with one "stylus" and fewer fields.
///
/// @returns FileNotFound, FileUnreadable, FileEmpty; UnknownFormat for another schema;
///          FileMalformed where the digest does not match, or a field is missing, of the wrong
///          type, unknown, or contradicts another. The detail names file, field and fault.
[[nodiscard]] Result<Site> readSiteFile(const std::filesystem::path& file);

/// Writes a site file atomically, for its owner's eyes only: it names the operator.
/// @returns FileUnwritable; FileMalformed for a site that readSiteFile would refuse, which leaves
///          the file as it was.
[[nodiscard]] Result<void> writeSiteFile(const std::filesystem::path& file, const Site& site);

} // namespace carina
