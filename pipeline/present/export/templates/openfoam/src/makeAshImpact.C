#if !defined(OPENFOAM) || OPENFOAM < 1900
    #error "Written for OpenFOAM.com (ESI), v1912; the Foundation's fork has another base class for patch interactions"
#endif

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
