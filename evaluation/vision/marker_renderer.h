#pragma once

#include "engine/vision/camera_model.h"
#include "engine/vision/grey_picture.h"
#include "engine/vision/marker_body.h"
#include "engine/vision/marker_dictionary.h"

#include <random>
#include <span>
#include <vector>

namespace carina
{

/// A body before the camera.
struct PosedBody {
    const MarkerBody* body = nullptr;
    RigidTransform X_TB;
};

/// A pattern of black and white cells on a plane, in the middle of its frame K (BodyMarker).
struct DrawnPattern {
    std::vector<bool> cells; ///< row by row from the upper left: true is white
    int columns = 0;
    double cell = 0.0; ///< its side, metres
    RigidTransform X_TK;
    double margin = 0.02; ///< white around it, metres
};

/// What a rendered picture looks like.
struct Rendering {
    int samples = 3;      ///< n, of which a pixel has n^2
    double blur = 0.5;    ///< standard deviation of the lens' blur, pixels
    double noise = 2.0;   ///< standard deviation of a pixel, of 255
    double black = 30.0;  ///< of the ink
    double white = 215.0; ///< of the paper, seen straight on
    std::uint32_t seed = 1;
};

/// Draws markers as a camera sees them, by following the line of sight of every sample of a pixel
/// to the nearest marker that faces the camera. The n^2 samples of a pixel are drawn, one in each
/// of n^2 columns and rows of it (Chiu, Shirley and Wang 1994): on a lattice of n by n an edge
/// along the rows of the picture would be off by as much as half of a pixel's n-th part. The camera
/// is the formula of CameraModel, which a test holds against OpenCV's; of OpenCV itself only the
/// cells of the markers are used.
class MarkerRenderer
{
public:
    MarkerRenderer(const CameraModel& camera, MarkerDictionary dictionary,
                   const Rendering& rendering);

    /// The next picture; the noise of each is another.
    [[nodiscard]] GreyPicture draw(std::span<const PosedBody> bodies);
    /// The same of one pattern, such as a board.
    [[nodiscard]] GreyPicture drawBoard(const DrawnPattern& pattern);

private:
    struct Exposure;

    [[nodiscard]] Exposure emptyRoom() const;
    void drawPattern(const DrawnPattern& pattern, Exposure& exposure) const;
    [[nodiscard]] GreyPicture developed(const std::vector<float>& grey);

    CameraModel m_camera;
    MarkerDictionary m_dictionary;
    Rendering m_rendering;
    std::mt19937 m_random;
    std::vector<Eigen::Vector2f> m_sights; // x and y of sightOf() for every sample
};

} // namespace carina
