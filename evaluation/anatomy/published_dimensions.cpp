#include "evaluation/anatomy/published_dimensions.h"

#include <array>

namespace carina
{
namespace
{

constexpr std::string_view kKamel = "CT of 60: Kamel, Lau, Stringer, Clin Anat 2009;22:571";
constexpr std::string_view kLee = "CT of 100: Lee et al., J Korean Radiol Soc 1988;24:265";
constexpr std::string_view kBreatnach =
    "radiographs of 808: Breatnach, Abbott, Fraser, AJR 1984;142:903; mean and deviation from "
    "the limits, which are three deviations away";
constexpr std::string_view kSternInspired =
    "CT of 10 men lying, after a full inspiration: Stern et al., Radiology 1993;187:27";
constexpr std::string_view kSternExpired =
    "CT of 10 men lying, after a forced expiration: Stern et al., Radiology 1993;187:27";
constexpr std::string_view kAngles =
    "quoted with ranges of 11.4 to 41.8 and 24.8 to 64.8 degrees; the paper was not found";
constexpr std::string_view kCords = "Caucasian adults: Br J Anaesth 2006";
constexpr std::string_view kCricoid = "31 larynges: Int J Otorhinolaryngol Head Neck Surg, doi "
                                      "10.18203/issn.2454-5929.ijohns20175054";
constexpr std::string_view kCricoidIndia =
    "50 larynges, sexes not told apart: Morphometric study of cricoid cartilages in Western "
    "India, PMID 23386865";
constexpr std::string_view kEpiglottis =
    "22 adults, embalmed: Vadgaonkar, F1000Research 2024;13:115";
constexpr std::string_view kEpiglottisKorea =
    "ultrasound of 100: Paik et al., J Korean Soc Emerg Med 2006;17:471";
constexpr std::string_view kFold =
    "whole fold at microlaryngeal surgery, 73 adults: Jibi Inkoka Keibu 125(6)";
constexpr std::string_view kGlottis = "Miller's Anesthesia, 6th edition";
constexpr std::string_view kLarynx =
    "50 larynges: Poornima, Dakshayini, Int J Anat Res 2017;5(2.1):3713";
constexpr std::string_view kTongue = "MRI of 70: Liegeois, Albert, Limme, Eur J Orthod 2010;32:381";
constexpr std::string_view kTongueSound =
    "ultrasound of 36: Head Face Med 2016, doi 10.1186/s13005-016-0110-4";
constexpr std::string_view kBigonial =
    "cone-beam CT of 99 aged 18 to 25: Mandibular sexual dimorphism in a Syrian sample, 2020";
constexpr std::string_view kSternum = "CT of 60 aged 20 to 40 (bibliomed 16478)";
constexpr std::string_view kGomez = "Gomez 2016";
constexpr std::string_view kTeethChild = "170 children: Anesthesiology 2008;108:1004";
constexpr std::string_view kInfants =
    "CT of 56 up to 3 years: Anesth Analg 2013;117(2), length of the subglottic airway";
constexpr std::string_view kGriscom =
    "CT of 34 up to 6 years, by height: Griscom and Wohl, dimensions of the trachea to age 6";
constexpr std::string_view kLobesSource = "CT of 32, supine: PMC7490509";

constexpr std::array kAll{
    PublishedDimension{.name = "trachea_length_mm",
                       .sex = Sex::Male,
                       .mean = 105.1,
                       .deviation = 9.8,
                       .source = kKamel},
    PublishedDimension{.name = "trachea_length_mm",
                       .sex = Sex::Female,
                       .mean = 98.3,
                       .deviation = 8.7,
                       .source = kKamel},
    PublishedDimension{.name = "trachea_length_mm",
                       .fromAge = 0.0,
                       .toAge = 3.0,
                       .mean = 45.0,
                       .perMonth = 0.5,
                       .source = kInfants},
    PublishedDimension{.name = "trachea_length_mm",
                       .fromAge = 0.0,
                       .toAge = 6.5,
                       .mean = 17.8,
                       .perCentimetre = 0.5,
                       .source = kGriscom},
    PublishedDimension{.name = "trachea_lumen_coronal_mm",
                       .sex = Sex::Male,
                       .mean = 17.7,
                       .deviation = 1.9,
                       .source = kLee},
    PublishedDimension{.name = "trachea_lumen_coronal_mm",
                       .sex = Sex::Female,
                       .mean = 15.3,
                       .deviation = 1.2,
                       .source = kLee},
    PublishedDimension{.name = "trachea_lumen_coronal_mm",
                       .sex = Sex::Male,
                       .mean = 19.0,
                       .deviation = 2.0,
                       .source = kBreatnach},
    PublishedDimension{.name = "trachea_lumen_coronal_mm",
                       .sex = Sex::Female,
                       .mean = 15.5,
                       .deviation = 1.8,
                       .source = kBreatnach},
    PublishedDimension{.name = "trachea_lumen_coronal_mm",
                       .fromAge = 0.0,
                       .toAge = 6.5,
                       .mean = 1.8,
                       .perCentimetre = 0.065,
                       .source = kGriscom},
    PublishedDimension{.name = "trachea_lumen_sagittal_mm",
                       .sex = Sex::Male,
                       .mean = 18.9,
                       .deviation = 2.1,
                       .source = kLee},
    PublishedDimension{.name = "trachea_lumen_sagittal_mm",
                       .sex = Sex::Female,
                       .mean = 15.5,
                       .deviation = 1.3,
                       .source = kLee},
    PublishedDimension{.name = "trachea_lumen_sagittal_mm",
                       .sex = Sex::Male,
                       .mean = 20.0,
                       .deviation = 2.3,
                       .source = kBreatnach},
    PublishedDimension{.name = "trachea_lumen_sagittal_mm",
                       .sex = Sex::Female,
                       .mean = 16.5,
                       .deviation = 2.2,
                       .source = kBreatnach},
    PublishedDimension{.name = "trachea_lumen_sagittal_mm",
                       .fromAge = 0.0,
                       .toAge = 6.5,
                       .mean = 0.5,
                       .perCentimetre = 0.070,
                       .source = kGriscom},
    PublishedDimension{.name = "trachea_lumen_ml",
                       .sex = Sex::Male,
                       .mean = 35.6,
                       .deviation = 6.8,
                       .source = kKamel},
    PublishedDimension{.name = "trachea_lumen_ml",
                       .sex = Sex::Female,
                       .mean = 24.7,
                       .deviation = 6.1,
                       .source = kKamel},
    PublishedDimension{.name = "trachea_lumen_mm2",
                       .sex = Sex::Male,
                       .mean = 288.0,
                       .deviation = 54.0,
                       .source = kLee},
    PublishedDimension{.name = "trachea_lumen_mm2",
                       .sex = Sex::Female,
                       .mean = 204.0,
                       .deviation = 31.0,
                       .source = kLee},
    PublishedDimension{.name = "trachea_lumen_mm2",
                       .sex = Sex::Male,
                       .mean = 280.0,
                       .deviation = 50.5,
                       .source = kSternInspired},
    PublishedDimension{.name = "trachea_lumen_mm2",
                       .sex = Sex::Male,
                       .mean = 178.0,
                       .deviation = 40.2,
                       .source = kSternExpired},
    PublishedDimension{
        .name = "right_bronchus_deg", .mean = 26.9, .deviation = 7.0, .source = kAngles},
    PublishedDimension{
        .name = "left_bronchus_deg", .mean = 46.2, .deviation = 8.0, .source = kAngles},
    PublishedDimension{.name = "subcarinal_deg", .mean = 78.0, .deviation = 20.0, .source = kKamel},
    PublishedDimension{.name = "teeth_to_carina_mm",
                       .sex = Sex::Male,
                       .mean = 114.13,
                       .perCentimetre = 0.72,
                       .source = kGomez},
    PublishedDimension{.name = "teeth_to_carina_mm",
                       .sex = Sex::Female,
                       .mean = 135.55,
                       .perCentimetre = 0.56,
                       .source = kGomez},
    PublishedDimension{.name = "teeth_to_carina_mm",
                       .fromAge = 0.0,
                       .toAge = 14.0,
                       .mean = 52.0,
                       .perCentimetre = 1.2,
                       .source = kTeethChild},
    PublishedDimension{
        .name = "cords_to_carina_mm", .mean = 127.0, .deviation = 16.0, .source = kCords},
    PublishedDimension{.name = "cords_to_carina_mm",
                       .fromAge = 0.0,
                       .toAge = 3.0,
                       .mean = 53.0,
                       .perMonth = 0.5,
                       .source = kInfants},
    PublishedDimension{.name = "glottis_mm", .sex = Sex::Male, .mean = 23.0, .source = kGlottis},
    PublishedDimension{.name = "glottis_mm", .sex = Sex::Female, .mean = 17.0, .source = kGlottis},
    PublishedDimension{
        .name = "vocal_fold_mm", .sex = Sex::Male, .mean = 14.8, .deviation = 3.0, .source = kFold},
    PublishedDimension{.name = "vocal_fold_mm",
                       .sex = Sex::Female,
                       .mean = 12.7,
                       .deviation = 2.3,
                       .source = kFold},
    PublishedDimension{
        .name = "epiglottis_length_mm", .mean = 29.1, .deviation = 0.5, .source = kEpiglottis},
    PublishedDimension{
        .name = "epiglottis_width_mm", .mean = 22.2, .deviation = 0.6, .source = kEpiglottis},
    PublishedDimension{
        .name = "epiglottis_thickness_mm", .mean = 2.6, .deviation = 0.3, .source = kEpiglottis},
    PublishedDimension{.name = "epiglottis_thickness_mm",
                       .sex = Sex::Male,
                       .mean = 2.41,
                       .deviation = 0.21,
                       .source = kEpiglottisKorea},
    PublishedDimension{.name = "epiglottis_thickness_mm",
                       .sex = Sex::Female,
                       .mean = 2.21,
                       .deviation = 0.18,
                       .source = kEpiglottisKorea},
    PublishedDimension{.name = "cricoid_arch_mm",
                       .sex = Sex::Male,
                       .mean = 7.69,
                       .deviation = 0.63,
                       .source = kCricoid},
    PublishedDimension{.name = "cricoid_arch_mm",
                       .sex = Sex::Female,
                       .mean = 6.50,
                       .deviation = 0.68,
                       .source = kCricoid},
    PublishedDimension{
        .name = "cricoid_arch_mm", .mean = 6.54, .deviation = 1.23, .source = kCricoidIndia},
    PublishedDimension{.name = "cricoid_lamina_mm",
                       .sex = Sex::Male,
                       .mean = 21.17,
                       .deviation = 2.31,
                       .source = kCricoid},
    PublishedDimension{.name = "cricoid_lamina_mm",
                       .sex = Sex::Female,
                       .mean = 18.38,
                       .deviation = 0.61,
                       .source = kCricoid},
    PublishedDimension{
        .name = "cricoid_lamina_mm", .mean = 21.45, .deviation = 1.97, .source = kCricoidIndia},
    PublishedDimension{.name = "cricoid_inner_coronal_mm",
                       .sex = Sex::Male,
                       .mean = 17.52,
                       .deviation = 2.64,
                       .source = kCricoid},
    PublishedDimension{.name = "cricoid_inner_coronal_mm",
                       .sex = Sex::Female,
                       .mean = 15.05,
                       .deviation = 1.02,
                       .source = kCricoid},
    PublishedDimension{.name = "cricoid_inner_sagittal_mm",
                       .sex = Sex::Male,
                       .mean = 14.11,
                       .deviation = 2.55,
                       .source = kCricoid},
    PublishedDimension{.name = "cricoid_inner_sagittal_mm",
                       .sex = Sex::Female,
                       .mean = 12.71,
                       .deviation = 0.45,
                       .source = kCricoid},
    PublishedDimension{
        .name = "thyroid_notch_to_cricoid_mm", .mean = 33.51, .deviation = 3.6, .source = kLarynx},
    PublishedDimension{
        .name = "epiglottis_to_cricoid_mm", .mean = 60.17, .deviation = 8.12, .source = kLarynx},
    PublishedDimension{
        .name = "tongue_ml", .sex = Sex::Male, .mean = 89.9, .deviation = 11.5, .source = kTongue},
    PublishedDimension{
        .name = "tongue_ml", .sex = Sex::Female, .mean = 68.9, .deviation = 7.0, .source = kTongue},
    PublishedDimension{.name = "tongue_ml",
                       .sex = Sex::Male,
                       .mean = 92.4,
                       .deviation = 9.8,
                       .source = kTongueSound},
    PublishedDimension{.name = "tongue_ml",
                       .sex = Sex::Female,
                       .mean = 67.2,
                       .deviation = 5.6,
                       .source = kTongueSound},
    PublishedDimension{.name = "bigonial_mm",
                       .sex = Sex::Male,
                       .mean = 95.17,
                       .deviation = 6.45,
                       .source = kBigonial},
    PublishedDimension{.name = "bigonial_mm",
                       .sex = Sex::Female,
                       .mean = 86.84,
                       .deviation = 4.81,
                       .source = kBigonial},
    PublishedDimension{.name = "manubrium_mm", .sex = Sex::Male, .mean = 53.6, .source = kSternum},
    PublishedDimension{
        .name = "manubrium_mm", .sex = Sex::Female, .mean = 47.6, .source = kSternum},
    PublishedDimension{
        .name = "sternal_body_mm", .sex = Sex::Male, .mean = 101.1, .source = kSternum},
    PublishedDimension{
        .name = "sternal_body_mm", .sex = Sex::Female, .mean = 87.5, .source = kSternum},
    PublishedDimension{.name = "right_lung_percent", .mean = 53.6, .source = kLobesSource}};

} // namespace

bool PublishedDimension::holdsFor(const PatientParameters& person) const
{
    return person.ageInYears >= fromAge && person.ageInYears <= toAge
           && (!sex || *sex == person.sex);
}

double PublishedDimension::meanFor(const PatientParameters& person) const
{
    return mean + perCentimetre * 100.0 * person.height.si + perMonth * 12.0 * person.ageInYears;
}

std::span<const PublishedDimension> publishedDimensions() { return kAll; }

} // namespace carina
