// How long it takes to fit four touched landmarks and a thousand points, beside Eigen::umeyama and,
// where it is installed, OpenCV's estimateAffine3D without scale; and how far the answers differ.
// Carina's fit also refuses unusable points and gives the residual of each. Prints one JSON object.

#include "bench/interleaved.h"
#include "engine/geometry/fit/rigid_fit.h"

#ifdef CARINA_HAS_OPENCV
#include <opencv2/calib3d.hpp>
#endif

#include <algorithm>
#include <cstdio>
#include <random>

namespace
{

using carina::LandmarkPair;
using carina::Mat4;
using carina::Vec3;

constexpr int kFew = 4;
constexpr int kMany = 1000;
constexpr int kSets = 64; ///< measured in turn, so that no branch is learnt by heart

struct Points {
    std::vector<LandmarkPair> pairs;
    Eigen::Matrix3Xd p_A;
    Eigen::Matrix3Xd p_M;
#ifdef CARINA_HAS_OPENCV
    cv::Mat cv_A;
    cv::Mat cv_M;
#endif
};

/// Points within some decimetres and 1 mm of noise, in an arbitrary pose.
Points somePoints(std::mt19937& random, int count)
{
    std::normal_distribution<double> part;
    const auto point = [&](double size) -> Vec3 {
        return {size * part(random), size * part(random), size * part(random)};
    };
    const carina::RigidTransform X_MA{
        carina::Quat{part(random), part(random), part(random), part(random)}, point(1.0)};
    Points points;
    points.p_A.resize(3, count);
    points.p_M.resize(3, count);
    for (int i = 0; i < count; ++i) {
        points.p_A.col(i) = point(0.15);
        points.p_M.col(i) = X_MA * points.p_A.col(i) + point(1e-3);
        points.pairs.push_back({points.p_A.col(i), points.p_M.col(i)});
    }
#ifdef CARINA_HAS_OPENCV
    // A row for each point: the same numbers in the same order.
    points.cv_A = cv::Mat(count, 3, CV_64F, points.p_A.data()).clone();
    points.cv_M = cv::Mat(count, 3, CV_64F, points.p_M.data()).clone();
#endif
    return points;
}

template <int Count> const std::vector<Points>& sets()
{
    static const std::vector<Points> all = [] {
        std::mt19937 random{Count};
        std::vector<Points> made;
        for (int i = 0; i < kSets; ++i)
            made.push_back(somePoints(random, Count));
        return made;
    }();
    return all;
}

Mat4 carinas(const Points& points) { return carina::fitRigid(points.pairs)->X_AM.matrix(); }

Mat4 eigens(const Points& points) { return Eigen::umeyama(points.p_M, points.p_A, false); }

#ifdef CARINA_HAS_OPENCV
Mat4 openCvs(const Points& points)
{
    const cv::Mat rows = cv::estimateAffine3D(points.cv_M, points.cv_A, nullptr, true);
    Mat4 X_AM = Mat4::Identity();
    for (int i = 0; i < 12; ++i)
        X_AM(i / 4, i % 4) = rows.at<double>(i / 4, i % 4);
    return X_AM;
}
#endif

template <int Count, auto Fit> void measured(benchmark::State& state)
{
    const std::vector<Points>& all = sets<Count>();
    std::size_t next = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(Fit(all[++next % kSets]));
}

template <int Count> void carinasTime(benchmark::State& state)
{
    const std::vector<Points>& all = sets<Count>();
    std::size_t next = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(carina::fitRigid(all[++next % kSets].pairs));
}

/// The largest difference of a coefficient, as a share of the largest coefficient.
template <int Count> double difference(Mat4 (*one)(const Points&), Mat4 (*other)(const Points&))
{
    double largest = 0.0;
    for (const Points& points : sets<Count>()) {
        const Mat4 a = one(points);
        largest =
            std::max(largest, (a - other(points)).cwiseAbs().maxCoeff() / a.cwiseAbs().maxCoeff());
    }
    return largest;
}

void printPeer(const char* name, const std::map<std::string, double>& times,
               Mat4 (*peer)(const Points&))
{
    const auto ns = [&](const std::string& who, int count) {
        return times.at(who + " of " + std::to_string(count));
    };
    std::printf("  \"%s\": {\"median_ns_4\": %.0f, \"median_ns_1000\": %.0f,\n"
                "    \"ratio_4\": %.2f, \"ratio_1000\": %.2f, \"difference\": %.1e},\n",
                name, ns(name, kFew), ns(name, kMany), ns("carina", kFew) / ns(name, kFew),
                ns("carina", kMany) / ns(name, kMany),
                std::max(difference<kFew>(carinas, peer), difference<kMany>(carinas, peer)));
}

} // namespace

int main()
{
    std::map<std::string, void (*)(benchmark::State&)> all{
        {"carina of 4", carinasTime<kFew>},
        {"carina of 1000", carinasTime<kMany>},
        {"umeyama of 4", measured<kFew, eigens>},
        {"umeyama of 1000", measured<kMany, eigens>}};
#ifdef CARINA_HAS_OPENCV
    all.insert(
        {{"opencv of 4", measured<kFew, openCvs>}, {"opencv of 1000", measured<kMany, openCvs>}});
#endif
    const auto times = carina::medianTimes_ns(all);
    std::printf("{\n  \"schema\": \"carina.bench.rigid_fit/1\",\n  \"repetitions\": %d,\n",
                carina::kRepetitions);
    printPeer("umeyama", times, eigens);
#ifdef CARINA_HAS_OPENCV
    printPeer("opencv", times, openCvs);
#endif
    std::printf("  \"carina\": {\"median_ns_4\": %.0f, \"median_ns_1000\": %.0f}\n}\n",
                times.at("carina of 4"), times.at("carina of 1000"));
    return 0;
}
