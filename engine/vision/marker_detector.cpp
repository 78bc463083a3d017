#include "engine/vision/marker_detector.h"

#include "engine/vision/edge_refinement.h"

#include <opencv2/aruco.hpp>

namespace carina
{

std::vector<DetectedMarker> seenMarkers(const GreyPicture& picture, MarkerDictionary dictionary)
{
    if (picture.pixels.empty())
        return {};
    // OpenCV does not write into it.
    const cv::Mat grey(picture.height, picture.width, CV_8UC1,
                       const_cast<std::uint8_t*>(picture.pixels.data()));
    std::vector<std::vector<cv::Point2f>> corners;
    std::vector<int> ids;
    const auto parameters = cv::aruco::DetectorParameters::create();
    parameters->cornerRefinementMethod = cv::aruco::CORNER_REFINE_NONE;
    try {
        cv::aruco::detectMarkers(grey, cv::aruco::getPredefinedDictionary(int(dictionary)), corners,
                                 ids, parameters);
    } catch (const cv::Exception&) {
        return {}; // a picture too small to be looked through
    }
    std::vector<DetectedMarker> seen;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        std::array<Vec2, 4> found;
        for (std::size_t k = 0; k < found.size(); ++k)
            found[k] = {double(corners[i][k].x), double(corners[i][k].y)};
        seen.push_back({ids[i], refinedCorners(picture, found, cellsOf(dictionary))});
    }
    return seen;
}

} // namespace carina
