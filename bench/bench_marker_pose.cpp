// How long it takes to compute the pose of a probe from four markers in known order, beside
// Eigen::umeyama and, where it is installed, OpenCV's estimateAffine3D without scale; with the
// check of each marker, which the peers lack; of five, one of which is elsewhere; and with the
// order of four unknown. Prints one JSON object, with the means of all calls and the medians of the
// repetitions; goal and ratios are about the means.

#include "bench/interleaved.h"
#include "engine/tracking/markers/marker_search.h"

#ifdef CARINA_HAS_OPENCV
#include <opencv2/calib3d.hpp>
#endif

#include <algorithm>
#include <cstdio>
#include <random>

namespace
{

using carina::Mat4;
using carina::Probe;
using carina::SeenMarker;
using carina::Vec3;

constexpr int kSets = 64; ///< measured in turn, so that no branch is learnt by heart

const Probe& probe()
{
    static const Probe made{.markers = {{{0.0, 0.0, 0.011}},
                                        {{0.050, 0.0, 0.0}},
                                        {{-0.010, 0.085, 0.004}},
                                        {{-0.042, -0.047, -0.017}}}};
    return made;
}

/// The same with a fifth: of four markers none can be left out.
const Probe& probeOfFive()
{
    static const Probe made = [] {
        Probe five = probe();
        five.markers.push_back({{0.032, -0.061, 0.023}});
        return five;
    }();
    return made;
}

struct Sight {
    std::vector<SeenMarker> seen; ///< four
    std::vector<SeenMarker> withOutlier;
    std::vector<Vec3> points;
    Eigen::Matrix3Xd p_T{3, 4};
    Eigen::Matrix3Xd p_O{3, 4};
#ifdef CARINA_HAS_OPENCV
    cv::Mat cv_T;
    cv::Mat cv_O;
#endif
};

/// The probe a metre away in an arbitrary orientation, with 0.1 mm of noise.
Sight someSight(std::mt19937& random)
{
    std::normal_distribution<double> part;
    const carina::RigidTransform X_TO{
        carina::Quat{part(random), part(random), part(random), part(random)},
        Vec3{0.1, -0.1, -1.0}};
    Sight sight;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3& p_OQ = probe().markers[i].p_OQ;
        const Vec3 p_TQ = X_TO * p_OQ + 5.8e-5 * Vec3{part(random), part(random), part(random)};
        sight.seen.push_back({.marker = i, .p_TQ = p_TQ});
        sight.points.push_back(p_TQ);
        sight.p_T.col(int(i)) = p_TQ;
        sight.p_O.col(int(i)) = p_OQ;
    }
    sight.withOutlier = sight.seen;
    sight.withOutlier[3].p_TQ += Vec3{0.02, 0.0, 0.0};
    sight.withOutlier.push_back({.marker = 4, .p_TQ = X_TO * probeOfFive().markers[4].p_OQ});
#ifdef CARINA_HAS_OPENCV
    // A row for each point: the same numbers in the same order.
    sight.cv_T = cv::Mat(4, 3, CV_64F, sight.p_T.data()).clone();
    sight.cv_O = cv::Mat(4, 3, CV_64F, sight.p_O.data()).clone();
#endif
    return sight;
}

const std::vector<Sight>& sights()
{
    static const std::vector<Sight> all = [] {
        std::mt19937 random{4};
        std::vector<Sight> made;
        for (int i = 0; i < kSets; ++i)
            made.push_back(someSight(random));
        return made;
    }();
    return all;
}

Mat4 eigens(const Sight& sight) { return Eigen::umeyama(sight.p_O, sight.p_T, false); }

#ifdef CARINA_HAS_OPENCV
Mat4 openCvs(const Sight& sight)
{
    const cv::Mat rows = cv::estimateAffine3D(sight.cv_O, sight.cv_T, nullptr, true);
    Mat4 X_TO = Mat4::Identity();
    for (int i = 0; i < 12; ++i)
        X_TO(i / 4, i % 4) = rows.at<double>(i / 4, i % 4);
    return X_TO;
}
#endif

auto carinas(const Sight& sight) { return carina::markerPose(probe(), sight.seen); }

auto carinasWithOutlier(const Sight& sight)
{
    return carina::markerPose(probeOfFive(), sight.withOutlier);
}

auto carinasSearch(const Sight& sight) { return carina::searchMarkers(probe(), sight.points); }

template <auto Pose> void measured(benchmark::State& state)
{
    std::size_t next = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(Pose(sights()[++next % kSets]));
}

/// The largest difference of a coefficient from that of a peer, as a share of the largest.
double difference(Mat4 (*peer)(const Sight&))
{
    double largest = 0.0;
    for (const Sight& sight : sights()) {
        const Mat4 ours = carinas(sight)->X_TO.matrix();
        largest = std::max(largest,
                           (ours - peer(sight)).cwiseAbs().maxCoeff() / ours.cwiseAbs().maxCoeff());
    }
    return largest;
}

void printPeer(const char* name, const std::map<std::string, carina::RepeatedTimes>& times,
               Mat4 (*peer)(const Sight&))
{
    const carina::RepeatedTimes& own = times.at("carina");
    const carina::RepeatedTimes& theirs = times.at(name);
    std::printf("  \"%s\": {\"mean_ns\": %.0f, \"median_ns\": %.0f, \"ratio\": %.2f, "
                "\"median_ratio\": %.2f, \"difference\": %.1e},\n",
                name, theirs.mean_ns, theirs.median_ns, own.mean_ns / theirs.mean_ns,
                own.median_ns / theirs.median_ns, difference(peer));
}

} // namespace

int main()
{
    std::map<std::string, void (*)(benchmark::State&)> all{
        {"carina", measured<carinas>},
        {"outlier", measured<carinasWithOutlier>},
        {"search", measured<carinasSearch>},
        {"umeyama", measured<eigens>}};
#ifdef CARINA_HAS_OPENCV
    all.insert({"opencv", measured<openCvs>});
#endif
    const auto times = carina::repeatedTimes(all);
    std::printf("{\n  \"schema\": \"carina.bench.marker_pose/2\",\n  \"repetitions\": %d,\n",
                carina::kRepetitions);
    printPeer("umeyama", times, eigens);
#ifdef CARINA_HAS_OPENCV
    printPeer("opencv", times, openCvs);
#endif
    const carina::RepeatedTimes& own = times.at("carina");
    std::printf("  \"carina\": {\"mean_us\": %.3f, \"median_us\": %.3f, \"outlier_mean_us\": %.2f, "
                "\"search_mean_us\": %.2f}\n}\n",
                1e-3 * own.mean_ns, 1e-3 * own.median_ns, 1e-3 * times.at("outlier").mean_ns,
                1e-3 * times.at("search").mean_ns);
    return 0;
}
