#include "models/scoring/try_words.h"

#include <QCoreApplication>

namespace carina
{
namespace
{

QString metricWords(const char* text) { return QCoreApplication::translate("Metric", text); }

QString courseText(Metric metric)
{
    switch (metric) {
    case Metric::TimeToView:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Time to the view"));
    case Metric::TimeToCords:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Time to the tube through the cords"));
    case Metric::TimeToBreath:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Time to the first breath"));
    case Metric::BladeTime:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Time of the blade in the mouth"));
    case Metric::Attempts:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Attempts"));
    case Metric::GlottisSeen:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Glottis seen, grade 1 or 2"));
    case Metric::GlotticOpening:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Glottic opening"));
    case Metric::InTrachea:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Tube in the trachea"));
    case Metric::InBronchus:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Tube in a main bronchus"));
    case Metric::InOesophagus:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Tube in the oesophagus"));
    case Metric::OesophagealTime:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Longest time in the oesophagus"));
    case Metric::Failed:
        return metricWords(
            QT_TRANSLATE_NOOP("Metric", "Failed: not within 150 s, or in the oesophagus"));
    case Metric::DepthError:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Depth, off the rule"));
    case Metric::AboveCarina:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Tip above the carina"));
    case Metric::CuffInflated:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Cuff inflated"));
    case Metric::PassedShut:
        return metricWords(
            QT_TRANSLATE_NOOP("Metric", "Tube passed where the virtual airway is shut"));
    default:
        return {};
    }
}

QString patientText(Metric metric)
{
    switch (metric) {
    case Metric::HeadExtension:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Extension of the head"));
    case Metric::LowestSaturation:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Lowest oxygen saturation"));
    case Metric::TimeBelow90:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Time below 90 % saturation"));
    case Metric::IncisorPeak:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Incisors, highest force"));
    case Metric::IncisorMean:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Incisors, mean force"));
    case Metric::IncisorWarning:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Incisors, time above 20 N"));
    case Metric::TonguePeak:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Tongue, highest force"));
    case Metric::TongueMean:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Tongue, mean force"));
    case Metric::TongueWarning:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Tongue, time above 40 N"));
    case Metric::TongueImpulse:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Tongue, force over time"));
    default:
        return {};
    }
}

QString handlingText(Metric metric)
{
    switch (metric) {
    case Metric::PlaneTilt:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Laryngoscope off its upright plane"));
    case Metric::HandPath:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Path of the laryngoscope"));
    case Metric::HandAcceleration:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Acceleration of the laryngoscope"));
    case Metric::HandJerk:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Jerk of the laryngoscope"));
    case Metric::HandSmoothness:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Smoothness of the laryngoscope"));
    case Metric::HeadTravel:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Your head, up and down"));
    case Metric::HeadAcceleration:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Acceleration of your head"));
    case Metric::HeadJerk:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Jerk of your head"));
    case Metric::Prepared:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Equipment prepared"));
    case Metric::MaskVentilated:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Mask ventilation"));
    case Metric::BladeFromRight:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Blade inserted as its kind is meant to"));
    case Metric::PressureAsked:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Pressure on the larynx asked for"));
    case Metric::Auscultated:
        return metricWords(QT_TRANSLATE_NOOP("Metric", "Both lungs auscultated, tube fixed"));
    default:
        return {};
    }
}

} // namespace

QString metricText(Metric metric)
{
    if (metric >= Metric::PlaneTilt)
        return handlingText(metric);
    return metric >= Metric::HeadExtension ? patientText(metric) : courseText(metric);
}

QString valueText(double value, MetricUnit unit)
{
    const auto with = [value](const char* text, int decimals) {
        return metricWords(text).arg(value, 0, 'f', decimals);
    };
    switch (unit) {
    case MetricUnit::YesOrNo:
        return value > 0.5 ? metricWords(QT_TRANSLATE_NOOP("Metric", "yes"))
                           : metricWords(QT_TRANSLATE_NOOP("Metric", "no"));
    case MetricUnit::Count:
        return with("%1", 0);
    case MetricUnit::Seconds:
        return with(QT_TRANSLATE_NOOP("Metric", "%1\u00a0s"), 1);
    case MetricUnit::Millimetres:
        return with(QT_TRANSLATE_NOOP("Metric", "%1\u00a0mm"), 0);
    case MetricUnit::Centimetres:
        return with(QT_TRANSLATE_NOOP("Metric", "%1\u00a0cm"), 0);
    case MetricUnit::Degrees:
        return with(QT_TRANSLATE_NOOP("Metric", "%1°"), 0);
    case MetricUnit::SquareDegrees:
        return with(QT_TRANSLATE_NOOP("Metric", "%1 square degrees"), 1);
    case MetricUnit::PerCent:
        return with(QT_TRANSLATE_NOOP("Metric", "%1\u00a0%"), 0);
    case MetricUnit::Newtons:
        return with(QT_TRANSLATE_NOOP("Metric", "%1\u00a0N"), 0);
    case MetricUnit::NewtonSeconds:
        return with(QT_TRANSLATE_NOOP("Metric", "%1\u00a0N\u00a0s"), 0);
    case MetricUnit::MetresPerSecond2:
        return with(QT_TRANSLATE_NOOP("Metric", "%1\u00a0m/s²"), 2);
    case MetricUnit::MetresPerSecond3:
        return with(QT_TRANSLATE_NOOP("Metric", "%1\u00a0m/s³"), 1);
    case MetricUnit::None:
        return with("%1", 1);
    }
    return {};
}

} // namespace carina
