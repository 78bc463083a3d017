#pragma once

#include "widgets/report/registration_report.h"

namespace carina::test
{

/// A picture of two halves.
inline QImage madePicture()
{
    QImage picture{640, 400, QImage::Format_RGB32};
    picture.fill(QColor{230, 230, 230});
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width() / 2; ++x)
            picture.setPixelColor(x, y, QColor{60, 60, 60});
    return picture;
}

/// A report with something in every section, and all its words and numbers different.
inline RegistrationReport wholeReport()
{
    const auto text = [](const char* words) { return QString::fromUtf8(words); };
    return {
        .siteFile = text("skills-lab-2.site.json"),
        .patient = text("Ana Borg"),
        .manikin = text("Airway trainer 3"),
        .tracker = text("Polaris Vega"),
        .operatorName = text("Jo Technician"),
        .date = text("2026-11-22T07:15:00Z"),
        .verdict = RegistrationReport::Verdict::Verified,
        .bound_mm = 1.97,
        .notes = {text("The chin probe was moved."), text("Two landmarks were exchanged.")},
        .checked = {{text("Suprasternal notch"), 0.81, 1.52}, {text("Nasion"), 1.12, 1.66}},
        .targets = {{text("Glottis"), 0.48, 0.93, text("front to back")},
                    {text("Carina"), 0.41, 0.72, text("left to right")},
                    {text("Incisors"), 0.54, 1.03, text("head to feet")},
                    {text("Left lung base"), 0.95, 1.91, text("front to back")},
                    {text("Right lung base"), 0.96, 1.92, text("front to back")}},
        .landmarks = {{text("Left jaw angle"), 0.11, 0.62, 0.85, 1.21},
                      {text("Right jaw angle"), 0.12, 0.63, 0.86, 1.22},
                      {text("Left tenth rib"), 0.13, 1.44, 0.87, 2.23},
                      {text("Right tenth rib"), 0.14, 0.35, 0.88, {}}},
        .fre_mm = 0.84,
        .fle = RegistrationReport::Localisation{1.19, 1.87},
        .stylus = RegistrationReport::Stylus{0.43, 0.06, 412, text("38 degrees to all sides"),
                                             text("2026-11-21T16:40:00Z")},
        .picture = madePicture(),
        .caption = text("Expected error, drawn on the skin."),
    };
}

} // namespace carina::test
