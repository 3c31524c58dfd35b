#if !defined(OPENFOAM)
    #error "No OPENFOAM is defined: this is OpenFOAM of the Foundation or foam-extend; AshImpact needs OpenFOAM.com (ESI), v1912 or later"
#elif OPENFOAM < 1900
    #error "OPENFOAM is before 1900: AshImpact needs OpenFOAM.com (ESI), v1912 or later"
#endif

#include "ash_table.h"  // in front of OpenFOAM, of which a later version has its own log() in view here

#include "basicKinematicCloud.H"
#include "basicKinematicCollidingCloud.H"
#include "basicKinematicMPPICCloud.H"
#include "basicThermoCloud.H"

#include "AshImpact.H"

#define addAshImpact(CloudType)                                                                         \
    typedef Foam::CloudType::kinematicCloudType CloudType##Kinematic;                                   \
    defineNamedTemplateTypeNameAndDebug(Foam::AshImpact<CloudType##Kinematic>, 0);                      \
    Foam::PatchInteractionModel<CloudType##Kinematic>::                                                 \
        adddictionaryConstructorToTable<Foam::AshImpact<CloudType##Kinematic>>                          \
            addAshImpact##CloudType##ToTable_;

addAshImpact(basicKinematicCloud)
addAshImpact(basicKinematicCollidingCloud)
addAshImpact(basicKinematicMPPICCloud)
addAshImpact(basicThermoCloud)
