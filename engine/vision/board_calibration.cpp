#include "engine/vision/board_calibration.h"

#include <opencv2/aruco/charuco.hpp>
#include <opencv2/calib3d.hpp>

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr double kOtherPlace = 0.03; ///< of the picture's width
constexpr double kPoorView = 3.0;    ///< times the median
constexpr double kPoorView_px = 0.5; ///< below which no view is poor

cv::Ptr<cv::aruco::CharucoBoard> openCvBoard(const CalibrationBoard& board)
{
    const double marker = board.square * (kCellsOfSquare - 2) / kCellsOfSquare;
    return cv::aruco::CharucoBoard::create(
        board.columns, board.rows, float(board.square), float(marker),
        cv::aruco::getPredefinedDictionary(int(board.dictionary)));
}

/// RMS angle between the board's normal and the line that the camera looks along.
Angle tiltOf(const std::vector<cv::Mat>& rotations)
{
    double squares = 0.0;
    for (const cv::Mat& rotation : rotations) {
        cv::Mat R;
        cv::Rodrigues(rotation, R);
        const double tilt = std::acos(std::clamp(std::abs(R.at<double>(2, 2)), 0.0, 1.0));
        squares += tilt * tilt / double(rotations.size());
    }
    return radians(std::sqrt(squares));
}

} // namespace

struct BoardCalibration::Board {
    cv::Ptr<cv::aruco::CharucoBoard> board;
};

std::vector<bool> cellsOf(const CalibrationBoard& board)
{
    constexpr int kPixels = 8; // of a cell
    const int columns = board.columns * kCellsOfSquare;
    const int rows = board.rows * kCellsOfSquare;
    cv::Mat drawn;
    openCvBoard(board)->draw({columns * kPixels, rows * kPixels}, drawn, 0, 1);
    std::vector<bool> cells;
    cells.reserve(std::size_t(columns) * std::size_t(rows));
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            cells.push_back(
                drawn.at<unsigned char>(row * kPixels + kPixels / 2, column * kPixels + kPixels / 2)
                > 127);
    return cells;
}

BoardCalibration::BoardCalibration(const CalibrationBoard& board)
    : m_board{std::make_unique<Board>(Board{openCvBoard(board)})}
{
}

BoardCalibration& BoardCalibration::operator=(BoardCalibration&&) noexcept = default;
BoardCalibration::~BoardCalibration() = default;

int BoardCalibration::pictures() const { return int(m_views.size()); }

std::optional<int> BoardCalibration::add(const GreyPicture& picture)
{
    if (!m_views.empty() && (picture.width != m_width || picture.height != m_height))
        return std::nullopt;
    const cv::Mat grey(picture.height, picture.width, CV_8UC1,
                       const_cast<std::uint8_t*>(picture.pixels.data())); // not written into
    std::vector<std::vector<cv::Point2f>> markers;
    std::vector<int> markerIds;
    std::vector<cv::Point2f> corners;
    View view;
    try {
        cv::aruco::detectMarkers(grey, m_board->board->dictionary, markers, markerIds);
        if (!markerIds.empty())
            cv::aruco::interpolateCornersCharuco(markers, markerIds, grey, m_board->board, corners,
                                                 view.ids);
    } catch (const cv::Exception&) {
        return std::nullopt; // a picture too small to be looked through
    }
    if (int(view.ids.size()) < kFewestCorners)
        return std::nullopt;
    for (const cv::Point2f& corner : corners)
        view.corners.push_back({double(corner.x), double(corner.y)});
    for (const View& kept : m_views) {
        double moved = 0.0;
        int both = 0;
        for (std::size_t i = 0; i < view.ids.size(); ++i) {
            const auto same = std::ranges::find(kept.ids, view.ids[i]);
            if (same == kept.ids.end())
                continue;
            moved += (kept.corners[std::size_t(same - kept.ids.begin())] - view.corners[i]).norm();
            ++both;
        }
        if (both > 0 && moved / both < kOtherPlace * picture.width)
            return std::nullopt;
    }
    m_width = picture.width;
    m_height = picture.height;
    m_views.push_back(std::move(view));
    return int(m_views.back().ids.size());
}

BoardCoverage BoardCalibration::coverage() const
{
    BoardCoverage coverage{};
    for (const View& view : m_views)
        for (const Vec2& corner : view.corners) {
            const int column = std::clamp(int(3.0 * corner.x() / m_width), 0, 2);
            const int row = std::clamp(int(3.0 * corner.y() / m_height), 0, 2);
            ++coverage[std::size_t(3 * row + column)];
        }
    return coverage;
}

std::optional<BoardFit> BoardCalibration::solve(const std::vector<const View*>& views,
                                                std::vector<double>& rmsOfView) const
{
    std::vector<std::vector<cv::Point3f>> points;
    std::vector<std::vector<cv::Point2f>> seen;
    for (const View* view : views) {
        auto& of = points.emplace_back();
        auto& at = seen.emplace_back();
        for (std::size_t i = 0; i < view->ids.size(); ++i) {
            of.push_back(m_board->board->chessboardCorners[std::size_t(view->ids[i])]);
            at.emplace_back(float(view->corners[i].x()), float(view->corners[i].y()));
        }
    }
    // A view of 58 degrees: from any usual one the fit goes on to the true one, also where the
    // board was never tilted and a closed form has no answer.
    const double focal = 0.9 * std::max(m_width, m_height);
    cv::Mat matrix = (cv::Mat_<double>(3, 3) << focal, 0.0, 0.5 * (m_width - 1), 0.0, focal,
                      0.5 * (m_height - 1), 0.0, 0.0, 1.0);
    cv::Mat distortion = cv::Mat::zeros(1, 5, CV_64F);
    std::vector<cv::Mat> rotations;
    cv::Mat spreads;
    cv::Mat perView;
    double rms = 0.0;
    try {
        rms = cv::calibrateCamera(points, seen, {m_width, m_height}, matrix, distortion, rotations,
                                  cv::noArray(), spreads, cv::noArray(), perView,
                                  cv::CALIB_FIX_K3 | cv::CALIB_USE_INTRINSIC_GUESS);
    } catch (const cv::Exception&) {
        return std::nullopt; // corners of which no camera follows
    }
    BoardFit fit{.camera = {.width = m_width,
                            .height = m_height,
                            .focal = {matrix.at<double>(0, 0), matrix.at<double>(1, 1)},
                            .centre = {matrix.at<double>(0, 2), matrix.at<double>(1, 2)}},
                 .rms = rms,
                 .tilt = tiltOf(rotations),
                 .pictures = int(views.size())};
    for (int i = 0; i < 5; ++i)
        fit.camera.distortion[std::size_t(i)] = distortion.at<double>(i);
    fit.focalSpread = std::max(spreads.at<double>(0) / fit.camera.focal.x(),
                               spreads.at<double>(1) / fit.camera.focal.y());
    rmsOfView.assign(perView.begin<double>(), perView.end<double>());
    return fit;
}

std::variant<BoardFit, CalibrationFault> BoardCalibration::fit() const
{
    if (pictures() < kFewestPictures)
        return CalibrationFault::TooFewPictures;
    if (std::ranges::count(coverage(), 0) > 0)
        return CalibrationFault::NotAllOver;
    std::vector<const View*> views;
    for (const View& view : m_views)
        views.push_back(&view);
    std::vector<double> rms;
    auto fit = solve(views, rms);
    if (fit) {
        std::vector<double> sorted = rms;
        std::ranges::nth_element(sorted, sorted.begin() + std::ssize(sorted) / 2);
        const double limit = std::max(kPoorView * sorted[sorted.size() / 2], kPoorView_px);
        std::vector<const View*> good;
        for (std::size_t i = 0; i < views.size(); ++i)
            if (rms[i] <= limit)
                good.push_back(views[i]);
        if (good.size() < views.size() && int(good.size()) >= kFewestPictures) {
            fit = solve(good, rms);
            if (fit)
                fit->left = int(views.size() - good.size());
        }
    }
    if (!fit || !(fit->rms < kLargestRms))
        return CalibrationFault::Contradictory;
    if (fit->tilt < kLeastTilt || !(fit->focalSpread <= kLargestFocalSpread)
        || !isUsable(fit->camera))
        return CalibrationFault::NotTilted;
    return *fit;
}

} // namespace carina
