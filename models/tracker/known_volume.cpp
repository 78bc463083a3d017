#include "models/tracker/known_volume.h"

#include <QCoreApplication>

#include <array>

namespace carina
{
namespace
{

QString volumeWords(const char* text) { return QCoreApplication::translate("KnownVolume", text); }

} // namespace

std::span<const KnownVolume> knownVolumes()
{
    static constexpr std::array kVolumes{KnownVolume::None, KnownVolume::PolarisPyramid,
                                         KnownVolume::PolarisExtended, KnownVolume::SimulatedCone};
    return kVolumes;
}

QString volumeName(KnownVolume volume)
{
    switch (volume) {
    case KnownVolume::None:
        break;
    case KnownVolume::PolarisPyramid:
        return volumeWords(QT_TRANSLATE_NOOP("KnownVolume", "Polaris, pyramid to 2.4\u00a0m"));
    case KnownVolume::PolarisExtended:
        return volumeWords(QT_TRANSLATE_NOOP("KnownVolume", "Polaris, extended to 3\u00a0m"));
    case KnownVolume::SimulatedCone:
        return volumeWords(QT_TRANSLATE_NOOP("KnownVolume", "Simulated tracker"));
    }
    return volumeWords(QT_TRANSLATE_NOOP("KnownVolume", "not known"));
}

std::optional<MeasurementVolume> volumeOf(KnownVolume volume)
{
    switch (volume) {
    case KnownVolume::None:
        break;
    case KnownVolume::PolarisPyramid:
        return polarisPyramid();
    case KnownVolume::PolarisExtended:
        return polarisExtendedPyramid();
    case KnownVolume::SimulatedCone:
        return simulatedCone();
    }
    return std::nullopt;
}

} // namespace carina
