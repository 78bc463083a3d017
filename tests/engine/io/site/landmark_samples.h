#pragma once

#include <string>

namespace carina::test
{

/// The same three landmarks in each of the formats that are exchanged with other programs.
inline const std::string kLandmarkTable = "name,x_mm,y_mm,z_mm\n"
                                          "\"Notch, upper\",0,-60.5,36\n"
                                          "\"Côte \"\"5\"\"\",80,-123,-111\n"
                                          "Tip,0.01,-131.5,-131.25\n";

inline const std::string kSlicerHeader =
    "# Markups fiducial file version = 4.13\n"
    "# CoordinateSystem = LPS\n"
    "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n";

inline const std::string kSlicerPoints = kSlicerHeader
                                         + "1,0,-60.5,36,0,0,0,1,1,1,0,\"Notch, upper\",,\n"
                                           "2,80,-123,-111,0,0,0,1,1,1,0,\"Côte \"\"5\"\"\",,\n"
                                           "3,0.01,-131.5,-131.25,0,0,0,1,1,1,0,Tip,,\n";

inline const std::string kSlicerPointsRas =
    "# Markups fiducial file version = 4.13\n"
    "# CoordinateSystem = RAS\n"
    "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n"
    "vtkMRMLMarkupsFiducialNode_0,-0.0,60.500,36.000,0,0,0,1,1,1,0,\"Notch, upper\",,\n"
    "vtkMRMLMarkupsFiducialNode_1,-80,123,-111,0,0,0,1,1,1,0,\"Côte \"\"5\"\"\",found,\n"
    "vtkMRMLMarkupsFiducialNode_2,-0.01,131.5,-131.25,0,0,0,1,1,0,1,Tip,,vtkMRMLModelNode4";

/// Beside a curve, and with a key that is not read.
inline const std::string kSlicerMarkups =
    R"({"@schema": "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/)"
    R"(Markups/Resources/Schema/markups-schema-v1.0.3.json#",
 "markups": [{"type": "Curve", "coordinateSystem": "RAS", "controlPoints": []},
  {"type": "Fiducial", "name": "Thorax", "coordinateSystem": "LPS", "coordinateUnits": "mm",
   "controlPoints": [
    {"label": "Notch, upper", "position": [0, -60.5, 36], "orientation": [1, 0, 0, 0, 1, 0, 0, 0, 1]},
    {"label": "Côte \"5\"", "position": [80, -123, -111]},
    {"label": "Tip", "position": [0.01, -131.5, -131.25], "positionStatus": "defined"}]}]})";

/// As little as is allowed, in the other axes.
inline const std::string kSlicerMarkupsRas =
    R"({"@schema": "markups-schema-v1.0.0.json#", "markups": [{"type": "Fiducial",
 "coordinateSystem": "RAS", "controlPoints": [{"label": "Notch, upper", "position": [0, 60.5, 36]},
  {"label": "Côte \"5\"", "position": [-80, 123, -111]},
  {"label": "Tip", "position": [-0.01, 131.5, -131.25]}]}]})";

} // namespace carina::test
