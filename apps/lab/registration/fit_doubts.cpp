#include "apps/lab/registration/fit_doubts.h"

#include <Eigen/Eigenvalues>

namespace carina::lab
{
namespace
{

/// Times the error of a touch: what the wizard calls weak, too.
constexpr double kWeak = 2.0;

/// A place as far from the line that landmarks are nearest to as they lie along it.
struct BesideLine {
    Vec3 p_A;
    Length away;
};

BesideLine besideLine(const std::vector<Vec3>& places)
{
    Vec3 middle = Vec3::Zero();
    for (const Vec3& p_A : places)
        middle += p_A / double(places.size());
    Mat3 scatter = Mat3::Zero();
    for (const Vec3& p_A : places)
        scatter += (p_A - middle) * (p_A - middle).transpose() / double(places.size());
    const Eigen::SelfAdjointEigenSolver<Mat3> axes{scatter}; // the longest last
    const double along = std::sqrt(axes.eigenvalues()[2]);
    return {middle + along * axes.eigenvectors().col(1), metres(along)};
}

QString withDecimal(Length length) { return QString::number(inMillimetres(length), 'f', 1); }

/// Such landmarks leave the turn about their line to the errors of the touches.
std::optional<QString> nearlyOnALine(const NamedPairs& named, Length fle)
{
    std::vector<Vec3> places;
    for (const LandmarkPair& pair : named.unweighted())
        places.push_back(pair.p_AQ);
    const auto covariance = fitCovariance(equalErrors(places, fle));
    if (!covariance)
        return std::nullopt; // which the fit refuses
    const BesideLine beside = besideLine(places);
    const Length error = targetError(*covariance, beside.p_A).rms;
    if (error <= kWeak * fle)
        return std::nullopt;
    return QStringLiteral(
               "The landmarks lie nearly on one line: %1 mm from that line, touches with an error "
               "of %2 mm cause an error of %3 mm (RMS); touch one more, far from that line.")
        .arg(withDecimal(beside.away), withDecimal(fle), withDecimal(error));
}

/// Whether each landmark that was exchanged was so with one other.
bool pairsUp(const std::vector<std::size_t>& touchOf)
{
    for (std::size_t i = 0; i < touchOf.size(); ++i)
        if (touchOf[touchOf[i]] != i)
            return false;
    return true;
}

} // namespace

std::optional<std::string> whyNotAsGiven(const std::vector<std::string>& names,
                                         const OrderFinding& order)
{
    if (order.order == TouchOrder::MirrorImage)
        return "the touches are the mirror image of the landmarks; turn the sign of one axis of "
               "either.";
    if (order.order != TouchOrder::Exchanged)
        return std::nullopt;
    std::string exchanged;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (order.touchOf[i] != i)
            exchanged += (exchanged.empty() ? "" : ", ") + names[i] + " has the touch of "
                         + names[order.touchOf[i]];
    const std::string symmetric = pairsUp(order.touchOf)
                                      ? " (a wrong sign of one axis looks the same where "
                                        "landmarks lie symmetrically)"
                                      : "";
    return "landmarks were exchanged: " + exchanged + "; put them right, or add --repair-order"
           + symmetric + ".";
}

QStringList fitWarnings(const NamedPairs& named, const OrderFinding& order, Length fle)
{
    QStringList sentences;
    if (const auto line = nearlyOnALine(named, fle))
        sentences << *line;
    if (order.order == TouchOrder::Unexplained)
        sentences << QStringLiteral("No order of the landmarks explains the touches: one was "
                                    "touched at a wrong place, which leave_one_out_mm may show; "
                                    "touch it again, or give the error of the touches with --fle.");
    return sentences;
}

} // namespace carina::lab
