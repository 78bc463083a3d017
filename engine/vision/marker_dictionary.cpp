#include "engine/vision/marker_dictionary.h"

#include "engine/core/expects.h"

#include <opencv2/aruco.hpp>

#include <iterator>

namespace carina
{
namespace
{

static_assert(std::size(kDictionaryWords) == std::size_t(MarkerDictionary::AprilTag36h11) + 1);
static_assert(int(MarkerDictionary::Original) == cv::aruco::DICT_ARUCO_ORIGINAL);
static_assert(int(MarkerDictionary::AprilTag36h11) == cv::aruco::DICT_APRILTAG_36h11);

cv::Ptr<cv::aruco::Dictionary> known(MarkerDictionary dictionary)
{
    return cv::aruco::getPredefinedDictionary(int(dictionary));
}

} // namespace

int cellsOf(MarkerDictionary dictionary) { return known(dictionary)->markerSize + 2; }

int sizeOf(MarkerDictionary dictionary) { return known(dictionary)->bytesList.rows; }

std::vector<bool> cellsOf(MarkerDictionary dictionary, int id)
{
    CARINA_EXPECTS(id >= 0 && id < sizeOf(dictionary));
    const auto markers = known(dictionary);
    const int inner = markers->markerSize;
    const cv::Mat bits =
        cv::aruco::Dictionary::getBitsFromByteList(markers->bytesList.row(id), inner);
    const int side = inner + 2;
    std::vector<bool> cells(std::size_t(side) * std::size_t(side), false);
    for (int row = 0; row < inner; ++row)
        for (int column = 0; column < inner; ++column)
            cells[std::size_t((row + 1) * side + column + 1)] =
                bits.at<unsigned char>(row, column) != 0;
    return cells;
}

} // namespace carina
