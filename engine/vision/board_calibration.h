#pragma once

#include "engine/core/units.h"
#include "engine/vision/camera_model.h"
#include "engine/vision/grey_picture.h"
#include "engine/vision/marker_dictionary.h"

#include <array>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace carina
{

/// A chessboard with markers in its white squares (ChArUco): each of its inner corners is known by
/// the markers around it, so that a part of the board is enough.
struct CalibrationBoard {
    int columns = 5; ///< squares
    int rows = 7;
    double square = 0.028; ///< its side, metres
    MarkerDictionary dictionary = MarkerDictionary::Bits5Of50;
};

/// Cells along the side of a square of the board; seven of them are a marker's.
inline constexpr int kCellsOfSquare = 9;

/// The cells of a board, row by row from its upper left corner: true is white.
[[nodiscard]] std::vector<bool> cellsOf(const CalibrationBoard& board);

/// Why pictures of a board determine no camera.
enum class CalibrationFault : std::uint8_t {
    TooFewPictures, ///< with eight corners of the board or more
    NotAllOver,     ///< a ninth of the picture has no corner in any of them
    NotTilted,      ///< by 10 degrees (RMS), or the focal length is uncertain by more than 1 %
    Contradictory,  ///< the corners lie 1.5 pixels or more from where this camera sees them
};

/// A camera as its pictures of a board determine it.
struct BoardFit {
    CameraModel camera;
    double rms = 0.0;         ///< distance of corners from where the camera sees them, pixels
    double focalSpread = 0.0; ///< standard deviation of the focal lengths, as a share of them
    Angle tilt{};             ///< of the board against the picture, RMS
    int pictures = 0;         ///< that were used
    int left = 0;             ///< pictures left out because they fit three times worse than most
};

/// Corners in each ninth of the picture, row by row.
using BoardCoverage = std::array<int, 9>;

/// Calibrates a camera with pictures of a board (Zhang 2000, by OpenCV): focal lengths, centre, k1,
/// k2, p1 and p2.
class BoardCalibration
{
public:
    static constexpr int kFewestPictures = 10;
    static constexpr int kFewestCorners = 8;
    static constexpr double kLargestRms = 1.5; ///< pixels
    static constexpr double kLargestFocalSpread = 0.01;
    static constexpr Angle kLeastTilt = degrees(10.0);

    explicit BoardCalibration(const CalibrationBoard& board);
    BoardCalibration& operator=(BoardCalibration&&) noexcept;
    ~BoardCalibration();

    /// Looks for the board. A picture is not kept where it has fewer than kFewestCorners corners,
    /// another size than those before, or shows the board where a kept one does: corners moved by
    /// less than 3 % of the picture's width on the mean.
    /// @returns how many corners are seen; std::nullopt where the picture was not kept.
    std::optional<int> add(const GreyPicture& picture);

    [[nodiscard]] int pictures() const;
    [[nodiscard]] BoardCoverage coverage() const;

    /// The camera, or why there is none.
    [[nodiscard]] std::variant<BoardFit, CalibrationFault> fit() const;

private:
    struct Board;
    struct View {
        std::vector<int> ids;
        std::vector<Vec2> corners;
    };

    [[nodiscard]] std::optional<BoardFit> solve(const std::vector<const View*>& views,
                                                std::vector<double>& rmsOfView) const;

    std::unique_ptr<Board> m_board;
    std::vector<View> m_views;
    int m_width = 0;
    int m_height = 0;
};

} // namespace carina
